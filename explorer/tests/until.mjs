// Waiting in tests: for a condition, never for a time. This is the one place that lets time pass.

/** What `find` gives once that is something (not null, undefined or false); asked every so often [ms]. */
export async function until(find, what, { limit = 600_000, every = 20 } = {}) {
  const end = Date.now() + limit;
  for (;;) {
    const found = await find();
    if (found !== null && found !== undefined && found !== false) return found;
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await new Promise((resolve) => setTimeout(resolve, every));
  }
}
