// What a motion becomes outside the page: CSV with a row for each solver step, and Python code that computes the same to the last bit.

import type { Motion } from "../core/motion";
import type { Shaking } from "../floor/shaking";
import type { Body, ContactLaw, State } from "../core/core";
import type { SimulationInput } from "./simulation_input";

/** Numbers have all their digits. The friction ratio of a body in the air is infinite and written as
 * `inf`, as in the files of `rimroll simulate`. On a floor that moves, the motion of the table follows. */
export function toCsv(motion: Motion, shaking?: Shaking): string {
  const moments = motion.samples(1);
  const ground = Object.entries(shaking?.at(moments.column("t")) ?? {});
  const columns = moments.names
    .map((name) => moments.column(name))
    .concat(ground.map(([, column]) => column));
  const names = [...moments.names, ...ground.map(([name]) => name)];
  const rows = Array.from({ length: moments.length }, (_, k) =>
    columns.map((column) => cell(column[k] as number)).join(","),
  );
  return [names.join(","), ...rows, ""].join("\n");
}

const cell = (value: number) => digits(value).replace("Infinity", "inf").replace("NaN", "nan");

// Writes Python code that computes the same motion to the last bit.

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

/** Writes a number with all its digits, and −0 with its sign, as Python and spreadsheets read it. */
export const digits = (value: number): string => (Object.is(value, -0) ? "-0.0" : String(value));

// Saves a text as a download.

export function download(name: string, text: string, type: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: `${type};charset=utf-8` }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // Safari reads the address only later.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
