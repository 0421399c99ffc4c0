// The last seconds of ticks, in rings that are never enlarged.

export const COLUMNS = ["q_rad", "q_more_rad", "p_WT_mm", "p_WP_mm", "error_mm", "force_sent_N", "cut_N"];
export const CUT_N = 1e-3; // of the force: more than that, and a limit has taken it away

const length = (vector) => Math.hypot(...vector);

export class History {
  constructor(seconds, hz) {
    this.size = Math.ceil(seconds * hz);
    this.seconds = seconds;
    this.clear(1000);
  }

  /** rate_hz: of the servo, whose ticks are counted. */
  clear(rate_hz) {
    this.rate_hz = rate_hz;
    this.time_s = new Float64Array(this.size);
    this.force_N = new Float64Array(this.size);
    this.error_mm = new Float64Array(this.size);
    this.count = 0;
    this.rows = 0; // that ever came
    this.latest = null;
  }

  /** Rows as the service sends them: a list for each column. */
  take(ticks) {
    const last = ticks.tick.length - 1;
    for (let row = 0; row <= last; ++row) {
      const at = this.count % this.size;
      this.time_s[at] = ticks.tick[row] / this.rate_hz;
      this.force_N[at] = length(ticks.force_sent_N[row]);
      this.error_mm[at] = ticks.error_mm[row];
      ++this.count;
    }
    this.rows += last + 1;
    this.latest = Object.fromEntries(COLUMNS.map((column) => [column, ticks[column][last]]));
    this.latest.q_rad = [...this.latest.q_rad, ...this.latest.q_more_rad]; // all eight, 0 where an arm has fewer
    this.latest.time_s = ticks.tick[last] / this.rate_hz;
  }

  /** Calls row(age_s, force_N, error_mm) from the oldest to the newest. */
  each(row) {
    const filled = Math.min(this.count, this.size);
    for (let back = filled; back > 0; --back) {
      const at = (this.count - back) % this.size;
      const age_s = this.latest.time_s - this.time_s[at];
      if (age_s <= this.seconds) row(age_s, this.force_N[at], this.error_mm[at]);
    }
  }
}
