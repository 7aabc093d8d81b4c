// A column that rolls without slip on a table which moves by a record, in rimroll's coordinates over the time.
#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// The acceleration of the table, linear between samples.
struct Record {
    static constexpr double STEP = 0.005;
    std::vector<std::array<double, 3>> samples;

    explicit Record(const std::string& path) {
        std::ifstream file(path);
        if (!file) throw std::runtime_error("cannot read " + path);
        for (std::string row; std::getline(file, row);) {
            std::array<double, 3> sample;
            char comma;
            std::istringstream(row) >> sample[0] >> comma >> sample[1] >> comma >> sample[2];
            samples.push_back(sample);
        }
    }
};

// (ψ, sin φ, cos φ, φ̇, ψ̇ sin φ, s) over t, between the samples i and i + 1.
class Column {
public:
    using State = std::array<double, 6>;
    static constexpr int SIN = 1, COS = 2;

    explicit Column(const Record& record) : record(record) {}

    void between(std::size_t i) {
        begin = Record::STEP * i;
        from = record.samples[i];
        for (int j = 0; j < 3; ++j)
            slope[j] = (record.samples[i + 1][j] - from[j]) / Record::STEP;
    }

    void rates(const State& u, State& rates, double t) const {
        // Per unit of mass.
        constexpr double R = 0.5, H = 2.0, A = 0.0625 + 16.0 / 12.0, C = 0.125, G = 9.81;
        constexpr double K = A + H * H, J = K + R * R, D = C * K + R * R * A;
        constexpr double L_OF_S = C * (C + R * R) / D, L_OF_W = C * H * R / D;
        constexpr double S_OF_W = R * R * A / D;
        const double x = from[0] + slope[0] * (t - begin);
        const double y = from[1] + slope[1] * (t - begin);
        const double z = from[2] + slope[2] * (t - begin);
        const double sin_yaw = std::sin(u[0]), cos_yaw = std::cos(u[0]);
        const double along = x * cos_yaw + y * sin_yaw, across = y * cos_yaw - x * sin_yaw;
        const double sin = u[1], cos = u[2], p = u[3], w = u[4], s = u[5];
        const double yaw_rate = w / sin;
        rates[0] = yaw_rate;
        rates[1] = cos * p;
        rates[2] = -sin * p;
        const double rho = R * cos - H * sin, height = R * sin + H * cos;
        rates[3] = cos * yaw_rate * (K / J * w - H * R / J * s) +
                   w * (H * R / J * w - (C + R * R) / J * s) - (G + z) / J * rho +
                   along / J * height;
        rates[4] = p * (L_OF_S * s - L_OF_W * w - yaw_rate * cos) + H * C / D * across;
        rates[5] = p * (S_OF_W * w + L_OF_W * s) - R * A / D * across;
    }

private:
    const Record& record;
    std::array<double, 3> from{}, slope{};
    double begin = 0.0;
};
