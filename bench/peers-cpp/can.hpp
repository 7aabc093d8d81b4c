// The equations of motion of the paper's can, in rimroll's coordinates and as they are printed.
#pragma once

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

struct Start {
    double tilt, tilt_rate, yaw_rate, spin_rate;
};

// Per unit of mass; the sources are those of rimroll::presets::can_2007.
constexpr double R = 0.051, H = 0.069, A = 5.13e-3, C = 2.0e-3, G = 9.8;

inline bool rolls(const std::string& law) {
    if (law == "no_slip") return true;
    if (law == "frictionless") return false;
    throw std::runtime_error("knows no law " + law);
}

// (ψ, sin φ, cos φ, φ̇, ψ̇ sin φ, s, t) over τ, dt = sin φ dτ.
class Regular {
public:
    using State = std::array<double, 7>;
    static constexpr int YAW = 0, SIN = 1, COS = 2, TILT_RATE = 3, TIME = 6;

    explicit Regular(const std::string& law) : no_slip(rolls(law)) {}

    static State begin(const Start& start) {
        const double sin = std::sin(start.tilt), cos = std::cos(start.tilt);
        return {0.0, sin, cos, start.tilt_rate, start.yaw_rate * sin,
                start.spin_rate + start.yaw_rate * cos, 0.0};
    }

    void rates(const State& u, State& rates) const {
        const double sin = u[1], cos = u[2], p = u[3], w = u[4], s = u[5];
        rates[0] = w;
        rates[1] = sin * cos * p;
        rates[2] = -sin * sin * p;
        rates[6] = sin;
        if (no_slip) {
            constexpr double K = A + H * H, J = K + R * R, D = C * K + R * R * A;
            constexpr double L_OF_S = C * (C + R * R) / D, L_OF_W = C * H * R / D;
            constexpr double S_OF_W = R * R * A / D;
            const double collision = cos * w * (K / J * w - H * R / J * s);
            const double elsewhere = w * (H * R / J * w - (C + R * R) / J * s) - G * R / J * cos +
                                     G * H / J * sin;
            rates[3] = collision + sin * elsewhere;
            rates[4] = p * (sin * (L_OF_S * s - L_OF_W * w) - w * cos);
            rates[5] = sin * p * (S_OF_W * w + L_OF_W * s);
        } else {
            const double rho = R * cos - H * sin, z = R * sin + H * cos;
            const double elsewhere = rho * (z * p * p - G) - C * w * s;
            rates[3] = (A * w * w * cos + sin * elsewhere) / (A + rho * rho);
            rates[4] = p * (sin * (C / A) * s - w * cos);
            rates[5] = 0.0;
        }
    }

private:
    bool no_slip;
};

// (ψ, φ, θ, ψ̇, φ̇, θ̇) over t: the printed Q q̈ = S, solved by Cramer's rule.
class Printed {
public:
    using State = std::array<double, 6>;
    static constexpr int YAW = 0, TILT_RATE = 4;

    explicit Printed(const std::string& law) : no_slip(rolls(law)) {}

    static State begin(const Start& start) {
        return {0.0, start.tilt, 0.0, start.yaw_rate, start.tilt_rate, start.spin_rate};
    }

    void rates(const State& u, State& rates) const {
        const double sin = std::sin(u[1]), cos = std::cos(u[1]);
        const double psi = u[3], phi = u[4], theta = u[5];  // rates
        rates[0] = psi;
        rates[1] = phi;
        rates[2] = theta;
        if (no_slip) {  // Eq. (noslip_eqs)
            const double q11 = (A + H * H) * sin - H * R * cos, q13 = -H * R;
            const double q31 = (C + R * R) * cos - R * H * sin, q33 = C + R * R;
            const double s1 = (C - 2 * A - 2 * H * H) * psi * phi * cos + C * phi * theta -
                              2 * H * R * psi * phi * sin;
            const double s2 = (C - A + R * R - H * H) * psi * psi * sin * cos +
                              (C + R * R) * theta * psi * sin + H * R * psi * theta * cos +
                              H * R * psi * psi * (cos * cos - sin * sin) +
                              G * (R * cos - H * sin);
            const double s3 =
                C * psi * phi * sin + 2 * R * psi * phi * (R * sin + H * cos);
            const double determinant = q11 * q33 - q13 * q31;
            rates[3] = (s1 * q33 - q13 * s3) / determinant;
            rates[4] = -s2 / (R * R + H * H + A);
            rates[5] = (q11 * s3 - s1 * q31) / determinant;
        } else {  // Eq. (nofric_eqs)
            const double q22 =
                -A + 2 * H * R * sin * cos - H * H * sin * sin - R * R * cos * cos;
            const double s1 = -2 * A * psi * phi * cos + C * phi * theta + C * phi * psi * cos;
            const double s2 = (C - A) * psi * psi * sin * cos + C * theta * psi * sin +
                              G * R * cos - G * H * sin -
                              H * R * phi * phi * (cos * cos - sin * sin) +
                              (H * H - R * R) * phi * phi * sin * cos;
            rates[3] = s1 / (A * sin);
            rates[4] = s2 / q22;
            rates[5] = psi * phi * sin - rates[3] * cos;
        }
    }

private:
    bool no_slip;
};
