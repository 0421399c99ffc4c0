// Three settings as sliders, each chosen by its path from those that the service has.

const COUNT = 3;
const WISHED = ["/control/kp_N_per_mm", "/control/kd_N_s_per_mm", "/control/ki_N_per_mm_s"];
const STEPS = 200;

/** The range of a slider: the setting's own, or one around its value where it has no end. */
function rangeOf(setting, value) {
  const low = setting.min ?? Math.min(0, 2 * value);
  const ordinary = Math.max(2 * Math.abs(value), 2 * Math.abs(Number(setting.default) || 0), 1);
  const high = setting.max !== undefined && setting.max <= 100 * ordinary ? setting.max : ordinary;
  return { low, high: Math.max(high, value, low + 1e-9) };
}

const capital = (label) => label.charAt(0).toUpperCase() + label.slice(1);
const isSliding = (setting) => typeof setting.value === "number" && ["number", "gain"].includes(setting.type);

class Slider {
  constructor(number, set, chosen) {
    this.set = set;
    this.element = document.createElement("fieldset");
    this.element.innerHTML = `
      <select aria-label="Setting of slider ${number}"></select>
      <div class="row"><input type="range" min="0" max="${STEPS}" step="1"><output></output></div>`;
    [this.select, this.range, this.output] = ["select", "input", "output"].map((name) => this.element.querySelector(name));
    this.select.addEventListener("change", () => chosen());
    this.range.addEventListener("input", () => this.slide());
    this.sending = this.next = null;
  }

  offer(settings, path) {
    this.select.replaceChildren(
      ...settings.map(({ path: one, label }) => new Option(`${capital(label)} (${one})`, one, false, one === path)),
    );
  }

  show(setting) {
    this.setting = setting;
    this.scope = rangeOf(setting, setting.value);
    this.range.value = String(Math.round((STEPS * (setting.value - this.scope.low)) / (this.scope.high - this.scope.low)));
    this.say(setting.value);
  }

  say(value) {
    const text = `${Number(value.toPrecision(3))} ${this.setting.unit}`.trim();
    this.output.textContent = text;
    this.range.setAttribute("aria-label", capital(this.setting.label));
    this.range.setAttribute("aria-valuetext", text);
  }

  slide() {
    const value = this.scope.low + ((this.scope.high - this.scope.low) * Number(this.range.value)) / STEPS;
    const shown = Number(value.toPrecision(6));
    this.say(shown);
    this.send(shown);
  }

  /** One request at a time; while it is under way, the newest value waits. */
  async send(value) {
    if (this.sending) {
      this.next = value;
      return;
    }
    this.sending = true;
    await this.set(this.setting.path, value);
    this.sending = false;
    const { next } = this;
    this.next = null;
    if (next !== null) this.send(next);
  }

  enable(on) {
    this.range.disabled = !on;
  }
}

export class Sliders {
  /** set(path, value): asks the service; a promise that never fails. */
  constructor(place, set) {
    this.sliders = Array.from({ length: COUNT }, (_, index) => new Slider(index + 1, set, () => this.refresh()));
    place.append(...this.sliders.map(({ element }) => element));
    this.settings = [];
    this.enable(false);
  }

  /** Another scene, or other values of it: all settings anew. Where a hand slides, its value stays. */
  take(settings) {
    this.settings = settings.filter(isSliding);
    const paths = this.settings.map(({ path }) => path);
    const ordered = [...WISHED.filter((path) => paths.includes(path)), ...paths.filter((path) => !WISHED.includes(path))];
    this.sliders.forEach((slider, index) => {
      const kept = paths.includes(slider.select.value) ? slider.select.value : ordered[Math.min(index, ordered.length - 1)];
      slider.element.hidden = kept === undefined;
      if (kept !== undefined) slider.offer(this.settings, kept);
    });
    this.refresh();
  }

  refresh() {
    for (const slider of this.sliders) {
      const setting = this.settings.find(({ path }) => path === slider.select.value);
      if (setting && !slider.sending) slider.show(setting);
    }
  }

  enable(on) {
    for (const slider of this.sliders) slider.enable(on);
  }
}
