#include "stridor/io/chart/chart_tables.hpp"

#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/boundaries.hpp"

#include <string_view>

namespace stridor::io {

void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder) {
    storage::PiecewiseFile table((folder / "chart.csv").string());
    chart_csv(result, "chart.toml", [&](std::string_view piece) { table.write(piece); });
    table.commit();
    storage::write_file((folder / "boundaries.csv").string(), boundaries_csv(result.study, sweep::boundaries(result)));
    write_chart_netcdf((folder / "chart.nc").string(), result);
}

}  // namespace stridor::io
