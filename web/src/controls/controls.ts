// The controls of the set-up: the body, its release and the table.

import { effect } from "@preact/signals-core";
import { choiceButtons, choiceList, type NumberName, numberRow } from "./inputs";
import { button, element } from "../elements";
import { SetupForm } from "./setup_form";
import type { Lab } from "../lab";
import { BODY_FIELDS } from "../setup/fields";
import { floorGroup } from "../floor/loading";
import { frictionRow, idleUnderIdealLaws, lossesRow } from "./table";
import { words } from "../words/words";

const RELEASE: NumberName[] = ["tilt", "tilt_rate", "sideways"];
const MORE: NumberName[] = ["twist", "yaw", "rolling", "restitution", "gravity", "duration"];

export function mountControls(lab: Lab, place: HTMLElement): void {
  const form = new SetupForm(lab);
  const idle = () => (isStanding(form) ? words.controls.standsFlat : undefined);
  const release = RELEASE.map((name) => numberRow(form, name, idle).row);
  place.append(
    element("h2", { class: "unseen" }, words.controls.title),
    element(
      "div",
      { class: "quantities" },
      choiceList(form, "body"),
      ...bodyRows(form),
      ...release,
      choiceButtons(form, "law"),
      frictionRow(form),
      more(form),
      floorGroup(form),
      otherRefusals(lab),
    ),
    element(
      "div",
      { class: "foot" },
      hintFor(place),
      button(words.letGo, () => form.letGo(), { class: "primary", id: "let-go" }),
      undoButton(form),
      button(words.controls.reset, () => form.reset(), { id: "reset" }),
    ),
  );
}

function undoButton(form: SetupForm): HTMLElement {
  const undo = button(words.controls.undo, () => form.undo(), { id: "undo" });
  effect(() => {
    // A disabled button would lose the focus after it is pressed.
    undo.setAttribute("aria-disabled", String(!form.lab.canUndo.value));
  });
  return undo;
}

/** Whether the body starts flat on its base, on a floor that moves. */
function isStanding({ lab }: SetupForm): boolean {
  const { floor, start } = lab.setup.value;
  return floor !== "rest" && start === "standing";
}

/** The numbers that only some bodies have, shown only with these bodies. */
function bodyRows(form: SetupForm): HTMLElement[] {
  const names = [...new Set(Object.values(BODY_FIELDS).flat())] as NumberName[];
  return names.map((name) => {
    const { row } = numberRow(form, name);
    row.classList.add("own");
    effect(() => {
      row.hidden = !BODY_FIELDS[form.lab.setup.value.body]?.includes(name);
    });
    return row;
  });
}

/** A window in which all quantities have room beside the table. */
const ROOMY = "(min-width: 60em) and (min-height: 64em)";

/** Less common quantities, folded; they open on large screens and when one of them is refused. */
function more(form: SetupForm): HTMLElement {
  const open = matchMedia(ROOMY).matches;
  const details = element(
    "details",
    { class: "more", open },
    element("summary", {}, words.controls.more),
  );
  for (const name of MORE) {
    if (name === "rolling") {
      details.append(lossesRow(form));
      continue;
    }
    const idle = name === "restitution" ? idleUnderIdealLaws(form) : undefined;
    details.append(numberRow(form, name, idle).row);
  }
  effect(() => {
    const inside: readonly string[] = MORE;
    if (form.lab.refusals.value.some(({ field }) => inside.includes(field))) details.open = true;
  });
  return details;
}

/** Settings of the playback and of a set-up that is compared, which a link may hold. */
const PLAYBACK: readonly string[] = ["speed", "slow", "view", "step", "with"];

/** Refusals from a link that have no visible field: of another body, or of the playback. */
function otherRefusals(lab: Lab): HTMLElement {
  const list = element("p", { class: "refusal", role: "alert" });
  effect(() => {
    const { body } = lab.setup.value;
    const hidden: string[] = Object.values(BODY_FIELDS)
      .flat()
      .filter((name) => !BODY_FIELDS[body]?.includes(name));
    const messages = lab.refusals.value
      .filter(({ field }) => PLAYBACK.includes(field) || hidden.includes(field))
      .map(({ message }) => message);
    list.textContent = messages.join(" ");
  });
  return list;
}

// Shows the help text of the quantity under the pointer or with the focus in one place, because a line
// under each quantity would leave no room for the table. Screen readers read it as a description.

export function hintFor(place: HTMLElement): HTMLElement {
  const hint = element("p", { class: "hint", "aria-hidden": "true" });
  const helpOf = (target: EventTarget | null) =>
    (target as Element | null)?.closest<HTMLElement>("[data-help]")?.dataset["help"];
  const say = (event: Event) => {
    const focused = place.contains(document.activeElement) ? document.activeElement : null;
    hint.textContent = helpOf(event.target) ?? helpOf(focused) ?? hint.textContent;
  };
  for (const kind of ["pointerover", "focusin", "input"]) place.addEventListener(kind, say);
  hint.textContent = words.controls.hint;
  return hint;
}
