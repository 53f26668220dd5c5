# The limits of Helmholtz's motion in a chart of a bowed string over bow position (x) and bow force (y):
#
#     sort -t, -k1,1g -k2,2g chart.csv | awk -f schelleng_limits.awk
#
# A cell is Helmholtz's motion if it is a squeal within 2 % of 200 Hz and slips for less than twice the bow's share b.
# Slopes are those of straight lines through the logarithms, by least squares.
BEGIN { FS = "," }
/^#/ || /^x,/ { next }
{
    b = $1; F = $2
    if ($5 != "squeal" || $19 < 196 || $19 > 204 || $6 >= 2 * b) next
    if (!(b in low)) { low[b] = F; place[++n] = b }
    high[b] = F
}
END {
    for (k = 1; k <= n; k++) {
        b = place[k]; x = log(b); l = log(low[b]); h = log(high[b])
        # Z = 0.35 kg/s, V = 0.1 m/s, mu_s - mu_d = 0.5, R = 20 kg/s
        printf "b %.3f  %.2f to %.2f N  (Schelleng %.2f to %.2f N)\n", b, low[b], high[b], \
            0.35 ^ 2 * 0.1 / (2 * 20 * b ^ 2 * 0.5), 2 * 0.35 * 0.1 / (b * 0.5)
        sx += x; sxx += x * x; sl += l; sxl += x * l; sh += h; sxh += x * h
    }
    d = n * sxx - sx * sx
    printf "slopes %.2f and %.2f\n", (n * sxl - sx * sl) / d, (n * sxh - sx * sh) / d
}
