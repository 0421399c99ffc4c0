// The page: connects, subscribes, draws 60 pictures a second of 200 ticks, and steers where it may.
import arms from "arms";
import { Desk } from "./desk.js";
import { COLUMNS, History } from "./history.js";
import { Plot } from "./plot.js";
import { Sliders } from "./sliders.js";
import { View } from "./view.js";
import { Wire } from "./wire.js";

const HZ = 200;
const SECONDS = 5;
const NAME = `browser page ${100 + Math.floor(900 * Math.random())}`; // one of several, perhaps
const NUMBERS_MS = 100; // a number that changes faster cannot be read
const find = (id) => document.getElementById(id);

const desk = new Desk();
const history = new History(SECONDS, HZ);
const plot = new Plot(find("plot"));
const wire = new Wire({ onTicks: (ticks) => history.take(ticks), onEvent, onClose: ended });
const sliders = new Sliders(find("sliders"), (path, value) => steer("set", { values: { [path]: value } }));
let about = null; // what the service said of itself; null: no connection
let holder = ""; // who steers: NAME, another's name, "": nobody
let view = null;
try {
  view = new View(find("view"), arms);
} catch {
  find("view-keys").textContent = "This browser has no WebGL, so the arm is not drawn. Numbers, plot and settings work.";
}

/** A request; what is refused is said in the service's words. */
async function steer(what, keys) {
  try {
    const answer = await wire.ask(what, keys);
    desk.say("");
    return answer;
  } catch (error) {
    desk.say(error.message, true);
    if (what === "set") refresh();
    return null;
  }
}

/** by: who steers. may: whether this page may steer now, or take the steering by doing so. */
function showSteering(by, may) {
  holder = by;
  desk.steering({ by, is_ours: by === NAME, may, is_connected: about !== null });
  sliders.enable(about !== null && may);
}

async function askHolder() {
  const { steered_by = "", may_steer, mode } = await wire.ask("status");
  showSteering(steered_by, may_steer);
  desk.mode(mode);
}

let refreshing = null; // under way
let is_old = false; // something changed meanwhile
async function refresh() {
  is_old = true;
  if (refreshing) return;
  refreshing = true;
  while (is_old && wire.isOpen) {
    is_old = false;
    try {
      const [{ scene }, { settings }] = await Promise.all([wire.ask("scene"), wire.ask("settings")]);
      const left = view?.show(scene, about.arm) ?? [];
      find("not-drawn").textContent = left.length > 0 ? `Not drawn here: ${left.join(", ")}.` : "";
      find("seen-title").textContent = scene.title;
      sliders.take(settings);
    } catch (error) {
      if (wire.isOpen) desk.say(error.message, true);
    }
  }
  refreshing = null;
}

function onEvent(event) {
  if (event.event === "mode") desk.mode(event.mode);
  if (event.event === "fault") desk.say(event.sentence, true);
  if (event.event === "edit") refresh();
  if (event.event === "lease") askHolder().catch(() => {});
  if (event.event === "lag") desk.say(`This page was too slow: ${event.rows} ticks were left out.`, true);
}

function ended(sentence) {
  about = null;
  desk.say(sentence, true);
  desk.nothing();
  showSteering("", false);
}

async function connect() {
  desk.say("Connecting…");
  try {
    const greeting = await wire.connect(find("address").value.trim(), find("token").value.trim(), NAME);
    about = greeting;
    history.clear(greeting.rate_hz);
    desk.say(`Connected to ${greeting.program}: ${greeting.arm}, ${greeting.rate_hz} ticks a second.`);
    desk.mode(greeting.mode);
    await askHolder();
    await refresh();
    await wire.ask("subscribe", { columns: COLUMNS, hz: Math.min(HZ, greeting.rate_hz) });
  } catch (error) {
    about = null;
    wire.close();
    desk.say(error.message, true);
    showSteering("", false);
  }
}

find("connection").addEventListener("submit", (event) => {
  event.preventDefault();
  if (about === null) {
    connect();
  } else {
    wire.close();
  }
});
find("start").addEventListener("click", () => steer("start"));
find("stop").addEventListener("click", () => steer("stop"));
find("lease").addEventListener("click", () => steer("lease", { lease: holder === NAME ? "give" : "take" }));
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape" && about !== null) steer("stop");
});

const page = (globalThis.underactPage = { pictures: 0, rows: () => history.rows, links: () => view?.seen() }); // for tests
let numbers_at_ms = 0;
function picture(now_ms) {
  requestAnimationFrame(picture);
  const tick = history.latest;
  if (tick !== null && about !== null) {
    view?.place(tick);
    if (now_ms - numbers_at_ms >= NUMBERS_MS) {
      numbers_at_ms = now_ms;
      desk.numbers(tick, about.force_limit_N, arms[about.arm]);
    }
  }
  view?.draw(now_ms);
  plot.draw(history);
  ++page.pictures;
}
showSteering("", false);
requestAnimationFrame(picture);
