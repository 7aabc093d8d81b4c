// Writes Python code that computes the same motion to the last bit.

import type { Body, State, ContactLaw } from "../core/core";
import { digits } from "./digits";
import type { SimulationInput } from "./simulation_input";

export function toPython({ body, start, contactLaw, options, shaking }: SimulationInput): string {
  return `import math
import rimroll as rr

body = ${bodyCode(body)}
start = ${shaking?.python.start ?? startCode(start)}
law = ${lawCode(contactLaw)}${shaking ? `\nground = ${shaking.python.ground}` : ""}
motion = rr.simulate(body, start, law, duration=${options.duration}, gravity=${options.gravity},
                     rtol=${options.rtol}, max_steps=${options.maxSteps}${shaking ? `, ground=ground,\n                     flat="${shaking.python.flat}"` : ""})

print(motion.message)
for turn in motion.turns:
    print(f"turned by {math.degrees(turn.angle):.3f} degrees")
`;
}

const call = (name: string, fields: Record<string, number>) =>
  `${name}(${Object.entries(fields)
    .map(([field, value]) => `${field}=${digits(value)}`)
    .join(", ")})`;

const bodyCode = (b: Body) =>
  call("rr.Body", {
    mass: b.mass,
    radius: b.radius,
    height: b.height,
    transverse_inertia: b.transverseInertia,
    axial_inertia: b.axialInertia,
  });

const startCode = (s: State) =>
  call("rr.State", {
    tilt: s.tilt,
    tilt_rate: s.tiltRate,
    yaw: s.yaw,
    yaw_rate: s.yawRate,
    spin: s.spin,
    spin_rate: s.spinRate,
  });

function lawCode(contactLaw: ContactLaw): string {
  const { law, friction = 0, restitution = 0, rollingDry = 0 } = contactLaw;
  const names = { no_slip: "rr.NoSlip", frictionless: "rr.Frictionless", coulomb: "rr.Coulomb" };
  const numbers = law === "coulomb" ? { friction, ...(restitution > 0 && { restitution }) } : {};
  const resistance = rollingDry > 0 ? ` + rr.RollingResistance(dry=${rollingDry})` : "";
  return call(names[law], numbers as Record<string, number>) + resistance;
}
