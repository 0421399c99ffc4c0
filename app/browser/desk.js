// What the page says in words: mode, numbers, who steers, and what went wrong.

import { CUT_N } from "./history.js";
import { jointTexts } from "./kinematics.js";

const MODES = { stopped: "Stopped", running: "Running", fault: "Fault" };
const find = (id) => document.getElementById(id);
const fixed = (value, decimals) => (Number.isFinite(value) ? value.toFixed(decimals) : "–");

/** What is said of who steers, where it is not this page. */
function holderText(by, may) {
  if (by === "") return "Nobody is in control. The first change, or Start, takes control.";
  if (may) return `“${by}” is in control. The first change here takes it.`;
  return `“${by}” is in control. You can watch, and stop. The sliders work again once it releases control.`;
}

export class Desk {
  constructor() {
    this.parts = Object.fromEntries(
      ["message", "mode", "force", "error", "tip", "joints", "holder", "start", "stop", "lease", "connect", "view"].map((id) => [id, find(id)]),
    );
    this.described_s = 0;
  }

  say(sentence, is_bad = false) {
    this.parts.message.textContent = sentence;
    this.parts.message.classList.toggle("bad", is_bad);
  }

  mode(mode) {
    this.parts.mode.textContent = MODES[mode] ?? "–";
    this.parts.mode.classList.toggle("bad", mode === "fault");
  }

  /** by: who steers, "": nobody. may: this page may steer now, or take the steering by doing so. */
  steering({ by, is_ours, may, is_connected }) {
    this.parts.holder.textContent = !is_connected ? "–" : is_ours ? "This page is in control." : holderText(by, may);
    this.parts.lease.textContent = is_ours ? "Release control" : "Take control";
    this.parts.lease.disabled = !is_connected;
    this.parts.start.disabled = !is_connected || !may;
    this.parts.stop.disabled = !is_connected;
    this.parts.connect.textContent = is_connected ? "Disconnect" : "Connect";
  }

  /** arm: its file, undefined of an arm that this page does not have. */
  numbers(tick, force_limit_N, arm) {
    const force_N = Math.hypot(...tick.force_sent_N);
    const { force, error, tip, joints, view } = this.parts;
    force.textContent = `${fixed(force_N, 2)} N of ${fixed(force_limit_N, 2)} N${tick.cut_N > CUT_N ? ", cut by a limit" : ""}`;
    error.textContent = `${fixed(tick.error_mm, 1)} mm`;
    tip.textContent = `${tick.p_WT_mm.map((one) => fixed(one, 1)).join(", ")} mm`;
    joints.textContent = arm && arm.dh.length <= tick.q_rad.length ? jointTexts(arm, tick.q_rad).join(", ") : "–";
    if (Math.abs(tick.time_s - this.described_s) < 1) return;
    this.described_s = tick.time_s;
    view.setAttribute("aria-label", `The arm: tip at ${tip.textContent}, force ${force.textContent}, error ${error.textContent}.`);
  }

  nothing() {
    for (const name of ["mode", "force", "error", "tip", "joints"]) this.parts[name].textContent = "–";
    this.mode("");
  }
}
