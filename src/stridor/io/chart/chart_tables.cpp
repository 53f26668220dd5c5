#include "stridor/io/chart/chart_tables.hpp"

#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/boundaries.hpp"

#include <string_view>

namespace stridor::io {

void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports) {
    if (holds(exports, ChartFile::csv)) {
        storage::PiecewiseFile table((folder / "chart.csv").string());
        const auto put = [&](std::string_view piece) { table.write(piece); };
        chart_csv(result, {"chart.toml", exports.figures}, put);
        table.commit();
    }
    if (holds(exports, ChartFile::boundaries))
        storage::write_file((folder / "boundaries.csv").string(),
                            boundaries_csv(result.study, sweep::boundaries(result)));
    if (holds(exports, ChartFile::nc))
        write_chart_netcdf((folder / "chart.nc").string(), result, {.figures = exports.figures});
    if (holds(exports, ChartFile::zarr)) write_chart_zarr((folder / "chart.zarr").string(), result, exports.figures);
}

}  // namespace stridor::io
