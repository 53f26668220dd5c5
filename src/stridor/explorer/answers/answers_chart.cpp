#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/sent_columns.hpp"
#include "stridor/io/chart/json_chart.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/keeper.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr std::uint8_t no_result = 255;
// after the categories: none because the contact sticks, or because it locks
constexpr auto stuck = static_cast<std::uint8_t>(classification::category_names.size());
constexpr std::uint8_t locked = stuck + 1;

std::uint8_t code_of(const sweep::CellVerdict& cell) {
    if (cell.status != sweep::Status::done) return no_result;
    if (cell.quiet == classification::Quiet::locks) return locked;
    return cell.quiet == classification::Quiet::sticks ? stuck : static_cast<std::uint8_t>(cell.category);
}

std::string category_bytes(const sweep::SweepResult& result) {
    std::vector<std::uint8_t> codes;
    for (const sweep::CellVerdict& cell : result.cells)
        codes.push_back(code_of(cell));
    return base64_of<std::uint8_t>(codes);
}

// why the first cell without a result has none; empty where each has one
std::string gap_words(const sweep::SweepResult& result) {
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        if (result.cells[index].status != sweep::Status::done && !sweep::is_inferred(result, index))
            return sweep::computed_cell(result, index).message;
    return {};
}

// a chart on its way to the page, a line per look at it
class Frames {
public:
    Frames(std::string figure, std::shared_ptr<sweep::CellKeeper> keeper, const Send& send)
        : figure_(std::move(figure)),
          keeper_(std::move(keeper)),
          send_(send) {}

    // Is there something new to be seen of a round that takes long? Cells stay pale until they are shown.
    bool is_due(std::size_t done) const {
        constexpr std::chrono::seconds pause(1);
        return done > computed_ && Clock::now() - shown_ > pause;
    }

    void show(const sweep::SweepResult& result, bool is_done) {
        const std::vector<bool> stored = keeper_->stored();
        computed_ = static_cast<std::size_t>(std::count(stored.begin(), stored.end(), true));
        Json frame{{"schema", "stridor.explorer.chart/1"},
                   {"round", round_},
                   {"done", is_done},
                   {"computed", computed_},
                   {"total", result.cells.size()}};
        if (round_ == 0) {
            frame["x"] = Json::parse(io::axis_json(result.study.x));
            frame["y"] = Json::parse(io::axis_json(result.study.y));
            frame["directions"] = {"going", "coming"};
        }
        frame["category"] = category_bytes(result);
        frame["computed_mask"] = base64_of<std::uint8_t>(std::vector<std::uint8_t>(stored.begin(), stored.end()));
        if (const sweep::CellFigure* figure = sweep::find_cell_figure(figure_)) {
            const std::vector<double> values = sweep::figure_values(result, *figure);
            frame["figure"] = base64_of<float>(std::vector<float>(values.begin(), values.end()));
        }
        if (is_done) frame["gaps"] = gap_words(result);
        send_(frame.dump() + "\n");
        ++round_;
        shown_ = Clock::now();
    }

private:
    using Clock = std::chrono::steady_clock;

    std::string figure_;
    std::shared_ptr<sweep::CellKeeper> keeper_;
    const Send& send_;
    int round_ = 0;
    std::size_t computed_ = 0;  // [1] cells of the last look
    Clock::time_point shown_ = Clock::now();
};

}  // namespace

Response chart(const World& world, const Json& body, const std::stop_token&) {
    sweep::Study study = study_in(world, body);
    if (flag_in(body, "preview")) {
        study = sweep::preview(std::move(study));
        study.refine = sweep::sound_refinement(study, study.refine);
    }
    Response response;
    response.content_type = "application/x-ndjson";
    response.stream = [study = std::move(study), threads = world.threads](const Send& send,
                                                                          const std::stop_token& stop) {
        try {
            const auto keeper = std::make_shared<sweep::MemoryKeeper>(study);
            Frames frames(study.quantities.front(), keeper, send);
            sweep::RunOptions options;
            options.crew = crew::thread_crews(threads);
            options.stop = stop;
            options.progress = [&](const sweep::Progress& now) {
                if (frames.is_due(now.done)) frames.show(sweep::provisional(study, keeper), false);
            };
            options.round = [&] { frames.show(sweep::provisional(study, keeper), false); };
            const sweep::RunReport report = sweep::run(study, *keeper, options);
            if (report.ending == sweep::SweepEnding::completed) frames.show(sweep::load(study, keeper), true);
        } catch (const Error& error) {
            send(error_document(error) + "\n");
        }
    };
    return response;
}

}  // namespace stridor::explorer
