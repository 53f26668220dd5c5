#include "stridor/integration/exact/logbook.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace stridor::integration {

namespace {

void add_losses(EnergyBalance& balance, const Totals& sum) {
    balance.dashpot_loss += sum.dashpot_loss;
    balance.friction_loss += sum.friction_loss;
    balance.drive_work += sum.drive_work;
}

}  // namespace

Logbook::Logbook(record::Recorder& recorder, const Flows& flows, std::vector<double> knots)
    : recorder_(recorder),
      flows_(flows),
      knots_(std::move(knots)),
      end_(record::end_of(recorder.schedule())),
      samples_(sample_times(recorder.request().trace)) {
    while (knot_ < knots_.size() && knots_[knot_] <= 0.0)
        ++knot_;
}

double Logbook::next_stop_time() const {
    double next = spans()[span_].to;
    if (has_samples()) next = std::min(next, samples_.next_time());
    if (knot_ < knots_.size()) next = std::min(next, knots_[knot_]);
    return next;
}

Logbook::Stop Logbook::next_stop() const {
    const double time = next_stop_time();
    if (has_samples() && samples_.next_time() <= time) return Stop::sample;
    return knot_ < knots_.size() && knots_[knot_] <= time ? Stop::knot : Stop::end_of_span;
}

void Logbook::enter(const Transition& next, double now) {
    if (has_pending_ && now > pending_.from) tell();
    pending_ = {contact_of(next.mode), now, 0.0, next.slip_velocity, next.closing_speed};
    has_pending_ = true;
    losses_.impact_loss += next.impact_loss;
    losses_.friction_loss += next.friction_loss;
    losses_.drive_work += next.drive_work;
}

void Logbook::tell() {
    if (!has_told_ || pending_.state != told_.state) {
        recorder_.enter(0, pending_);
        recent_.add(pending_);
        told_ = pending_;
    }
    has_told_ = true;
    has_pending_ = false;
}

namespace {

void pass_sums(Memory& pass, Sums& sums) {
    for (Lanes& product : sums.product)
        pass(product);
    pass(sums.on_slip), pass(sums.on_surface);
    for (Lanes& peak : sums.peak)
        pass(peak);
}

void pass_totals(Memory& pass, Totals& totals) {
    for (int i = 0; i < most_coordinates; ++i)
        pass(totals.square_time[i]), pass(totals.peak_square[i]);
    pass(totals.dashpot_loss), pass(totals.friction_loss), pass(totals.drive_work), pass(totals.largest_force);
}

}  // namespace

void Logbook::pass(Memory& pass) {
    for (int mode = 0; mode < contact_modes; ++mode)
        pass_sums(pass, account_.full[mode]), pass_sums(pass, account_.part[mode]);
    pass(account_.largest_force);
    pass_totals(pass, banked_);
    pass(losses_), pass(pending_), pass(has_pending_), pass(has_told_), pass(told_);
    pass.below(knot_, knots_.size() + 1);
    pass.below(span_, spans().size());
    if (pass.restores() && has_told_) recorder_.enter(0, told_);
}

void Logbook::close(double now) {
    if (has_pending_ && now > pending_.from) tell();
}

void Logbook::bank() {
    add(banked_, totals(flows_, account_), 1.0);
    account_ = {};
}

void Logbook::end_span() {
    bank();
    add_losses(losses_, banked_);
    vibrate();
}

void Logbook::vibrate() {
    std::array<record::Vibration, most_coordinates> vibration;
    for (std::size_t dof = 0; dof < vibration.size(); ++dof)
        vibration[dof] = {banked_.square_time[dof], banked_.peak_square[dof]};
    const record::Span& span = spans()[span_];
    recorder_.vibrate(span_, span.to - span.from, std::span(vibration).first(static_cast<std::size_t>(flows_.dofs)));
    const record::Load load{0.0, 0.0, banked_.largest_force};
    recorder_.load(span_, {&load, 1});
    banked_ = {};
    ++span_;
}

EnergyBalance Logbook::losses() const {
    EnergyBalance balance = losses_;
    add_losses(balance, banked_);
    add_losses(balance, totals(flows_, account_));
    return balance;
}

void Logbook::fill_with_silence(const Sliding& sliding, const Kernel& loops, Lanes s, double now) {
    close(end_);
    bank();
    while (!is_full()) {
        const record::Span& span = spans()[span_];
        sliding.pass(loops, span.to - now, span.use, s, account_);
        bank();
        now = span.to;
        vibrate();
    }
}

void Logbook::fill_with_cycle(const Totals& period, double begin, double now, const std::stop_token& stop) {
    const double duration = now - begin;
    bank();
    repeat_period(recent_.since(begin), duration, end_, recorder_, stop);
    while (!is_full()) {
        add(banked_, period, (spans()[span_].to - now) / duration);
        now = spans()[span_].to;
        vibrate();
    }
}

}  // namespace stridor::integration
