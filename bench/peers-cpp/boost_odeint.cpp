// The turn of the can by Boost.odeint. bench/contest/worker.py describes the lines of standard input and
// of standard output.

#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "can.hpp"
#include "column.hpp"

namespace odeint = boost::numeric::odeint;

struct Question {
    std::string task, method, coordinates, law;
    double tolerance;
    int repeats;
    std::vector<Start> starts;
    std::string path;
};

// The best, or within a tenth of it, of 1, 1e-2, ... 1e-8.
constexpr double ATOL_OVER_RTOL = 1e-4;

// Attempted steps after which a start is given up.
constexpr int MOST_STEPS = 200000;

// On from u by steps of its own choice until the tilt has been largest; false if it does not get there.
template <class Equations, class Stepper>
bool rock(const Equations& equations, Stepper& stepper, typename Equations::State& u) {
    const auto system = [&](const auto& at, auto& rates, double) { equations.rates(at, rates); };
    double tau = 0.0, h = 1e-3;
    bool rising = false;
    for (int i = 0; i < MOST_STEPS; ++i) {
        if (stepper.try_step(system, u, tau, h) == odeint::fail) continue;
        const double p = u[Equations::TILT_RATE];
        if (!(std::abs(p) < 1e6) || h < 1e-300) return false;
        if (rising && p <= 0.0) return true;
        rising = p > 0.0;
    }
    return false;
}

// From there back to the maximum, with the tilt rate as clock (Hénon, Physica D 5 (1982) 412).
template <class Equations, class Stepper>
bool back_to_maximum(const Equations& equations, Stepper& stepper, typename Equations::State& u) {
    const auto system = [&](const auto& at, auto& rates, double) {
        equations.rates(at, rates);
        const double scale = 1.0 / rates[Equations::TILT_RATE];
        for (auto& rate : rates) rate *= scale;
    };
    double p = u[Equations::TILT_RATE], h = -p;
    for (int i = 0; i < 100 && p < 0.0; ++i) {
        if (h > -p) h = -p;
        stepper.try_step(system, u, p, h);
    }
    return p >= 0.0;
}

// The yaw and the tilt of a motion at the end of its two seconds, without events on the way.
template <class MakeStepper>
std::vector<double> motion(const Question& question, MakeStepper make_stepper) {
    constexpr double END = 2.0;
    const Regular equations(question.law);
    Regular::State u = Regular::begin(question.starts.at(0));
    auto stepper = make_stepper();
    const auto by_tau = [&](const auto& at, auto& rates, double) { equations.rates(at, rates); };
    double tau = 0.0, h = 1e-3;
    while (u[Regular::TIME] < END) stepper.try_step(by_tau, u, tau, h);
    const auto by_time = [&](const auto& at, auto& rates, double) {
        equations.rates(at, rates);
        const double scale = 1.0 / rates[Regular::TIME];
        for (auto& rate : rates) rate *= scale;
    };
    auto last = make_stepper();
    double t = u[Regular::TIME];
    h = END - t;
    while (t > END) {
        if (h < END - t) h = END - t;
        last.try_step(by_time, u, t, h);
    }
    return {u[Regular::YAW], std::atan2(u[Regular::SIN], u[Regular::COS])};
}

// The tilt of the column at the end of the record. A step ends at each sample; the method goes on there, because the
// rates are continuous.
template <class Stepper>
double shaken(Column& equations, const Record& record, double tilt, Stepper stepper) {
    Column::State u{0.0, std::sin(tilt), std::cos(tilt), 0.0, 0.0, 0.0};
    const auto by_time = [&](const auto& at, auto& rates, double t) { equations.rates(at, rates, t); };
    double t = 0.0, h = Record::STEP;
    for (std::size_t i = 0; i + 1 < record.samples.size(); ++i) {
        equations.between(i);
        const double end = Record::STEP * (i + 1);
        while (t < end) {
            const double wanted = h;
            const bool last = t + h >= end * (1.0 - 1e-14);
            if (last) h = end - t;
            if (stepper.try_step(by_time, u, t, h) == odeint::success && last) {
                t = end;
                h = std::max(h, wanted);
            }
            if (!(h > 1e-14)) return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return std::atan2(u[Column::SIN], u[Column::COS]);
}

template <class MakeStepper>
std::vector<double> all_shaken(const Question& question, MakeStepper make_stepper) {
    static const Record record(question.path.substr(0, question.path.rfind('/') + 1) + "record.csv");
    Column equations(record);
    std::vector<double> found;
    for (const Start& start : question.starts)
        found.push_back(shaken(equations, record, start.tilt, make_stepper()));
    return found;
}

template <class Equations, class MakeStepper>
std::vector<double> turns(const Question& question, MakeStepper make_stepper) {
    const Equations equations(question.law);
    std::vector<double> found;
    found.reserve(question.starts.size());
    for (const Start& start : question.starts) {
        auto u = Equations::begin(start);
        auto stepper = make_stepper();
        bool there = rock(equations, stepper, u);
        if (there) {
            auto last = make_stepper();
            there = back_to_maximum(equations, last, u);
        }
        found.push_back(there ? u[Equations::YAW] : std::numeric_limits<double>::quiet_NaN());
    }
    return found;
}

template <class Equations>
std::vector<double> by_method(const Question& question) {
    using State = typename Equations::State;
    const double rtol = question.tolerance, atol = ATOL_OVER_RTOL * rtol;
    if (question.method == "boost_rkf78")
        return turns<Equations>(question, [=] {
            return odeint::make_controlled(atol, rtol, odeint::runge_kutta_fehlberg78<State>());
        });
    if (question.method == "boost_dopri5")
        return turns<Equations>(question, [=] {
            return odeint::make_controlled(atol, rtol, odeint::runge_kutta_dopri5<State>());
        });
    if (question.method == "boost_bulirsch_stoer")
        return turns<Equations>(question,
                                [=] { return odeint::bulirsch_stoer<State>(atol, rtol); });
    throw std::runtime_error("knows no method " + question.method);
}

std::vector<double> answer(const Question& question) {
    if (question.task == "motion") {
        if (question.method != "boost_rkf78" || question.coordinates != "regular")
            throw std::runtime_error("knows no such motion");
        const double rtol = question.tolerance, atol = ATOL_OVER_RTOL * rtol;
        return motion(question, [=] {
            using Stepper = odeint::runge_kutta_fehlberg78<Regular::State>;
            return odeint::make_controlled(atol, rtol, Stepper());
        });
    }
    if (question.task == "shaken") {
        using State = Column::State;
        const double rtol = question.tolerance, atol = ATOL_OVER_RTOL * rtol;
        if (question.method == "boost_dopri5")
            return all_shaken(question, [=] {
                return odeint::make_controlled(atol, rtol, odeint::runge_kutta_dopri5<State>());
            });
        if (question.method == "boost_rkf78")
            return all_shaken(question, [=] {
                return odeint::make_controlled(atol, rtol, odeint::runge_kutta_fehlberg78<State>());
            });
        throw std::runtime_error("knows no method " + question.method);
    }
    if (question.coordinates == "regular") return by_method<Regular>(question);
    if (question.coordinates == "printed") return by_method<Printed>(question);
    throw std::runtime_error("knows no coordinates " + question.coordinates);
}

// The first four columns of a table of starts.
std::vector<Start> read_starts(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::vector<Start> starts;
    bool head = true;
    for (std::string row; std::getline(file, row);) {
        if (row.empty() || row[0] == '#') continue;
        if (std::exchange(head, false)) continue;
        Start at;
        char comma;
        std::istringstream cells(row);
        cells >> at.tilt >> comma >> at.tilt_rate >> comma >> at.yaw_rate >> comma >> at.spin_rate;
        starts.push_back(at);
    }
    return starts;
}

Question read(const std::string& line) {
    std::istringstream words(line);
    Question question;
    std::string path;
    words >> question.task >> question.method >> question.coordinates >> question.law >> question.tolerance >>
        question.repeats >> path;
    if (!words) throw std::runtime_error("cannot read '" + line + "'");
    question.path = path;
    question.starts = read_starts(path);
    return question;
}

double processor_seconds() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        try {
            const Question question = read(line);
            std::vector<double> found;
            const double begun = processor_seconds();
            for (int i = 0; i < question.repeats; ++i) found = answer(question);
            const double taken = processor_seconds() - begun;
            std::printf("%.17g", taken / (question.repeats * question.starts.size()));
            for (const double turn : found) std::printf(" %.17g", turn);
            std::printf("\n");
        } catch (const std::exception& complaint) {
            std::printf("error %s\n", complaint.what());
        }
        std::fflush(stdout);
    }
}
