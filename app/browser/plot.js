// The plot of the last seconds: force and error, each with its own axis.

const MARGIN = { left: 48, right: 56, top: 8, bottom: 24 };

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** The end of an axis: 1, 2 or 5 times a power of ten, not below min. */
function endOf(max, min) {
  const value = Math.max(max, min);
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((step) => step * power).find((end) => end >= value);
}

export class Plot {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.readColours();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.readColours());
  }

  readColours() {
    this.colours = Object.fromEntries(["text", "soft", "line", "force", "error", "panel"].map((name) => [name, colour(name)]));
  }

  fit() {
    const ratio = Math.min(devicePixelRatio, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    return { width, height };
  }

  draw(history) {
    const { width, height } = this.fit();
    const { pen, colours } = this;
    pen.clearRect(0, 0, width, height);
    const inner = { width: width - MARGIN.left - MARGIN.right, height: height - MARGIN.top - MARGIN.bottom };
    let [max_N, max_mm] = [0, 0];
    if (history.latest !== null)
      history.each((age_s, force_N, error_mm) => {
        max_N = Math.max(max_N, force_N);
        if (Number.isFinite(error_mm)) max_mm = Math.max(max_mm, error_mm);
      });
    const ends = [endOf(max_N, 0.5), endOf(max_mm, 5)];
    this.axes(inner, history.seconds, ends);
    if (history.latest === null) return;
    pen.save();
    pen.beginPath();
    pen.rect(MARGIN.left, MARGIN.top, inner.width, inner.height);
    pen.clip();
    pen.lineWidth = 2;
    for (const [index, name] of ["force", "error"].entries()) {
      pen.beginPath();
      pen.strokeStyle = colours[name];
      pen.setLineDash(index === 0 ? [] : [6, 3]);
      history.each((age_s, force_N, error_mm) => {
        const value = index === 0 ? force_N : error_mm;
        pen.lineTo(
          MARGIN.left + inner.width * (1 - age_s / history.seconds),
          MARGIN.top + inner.height * (1 - value / ends[index]),
        );
      });
      pen.stroke();
    }
    pen.restore();
  }

  axes(inner, seconds, [end_N, end_mm]) {
    const { pen, colours } = this;
    pen.font = "12px system-ui, sans-serif";
    pen.fillStyle = colours.soft;
    pen.strokeStyle = colours.line;
    pen.lineWidth = 1;
    pen.setLineDash([]);
    for (let part = 0; part <= 2; ++part) {
      const y = MARGIN.top + inner.height * (1 - part / 2);
      pen.beginPath();
      pen.moveTo(MARGIN.left, y);
      pen.lineTo(MARGIN.left + inner.width, y);
      pen.stroke();
      pen.textBaseline = part === 2 ? "top" : part === 0 ? "bottom" : "middle";
      pen.textAlign = "right";
      pen.fillText(`${(end_N * part) / 2} N`, MARGIN.left - 4, y);
      pen.textAlign = "left";
      pen.fillText(`${(end_mm * part) / 2} mm`, MARGIN.left + inner.width + 4, y);
    }
    pen.textBaseline = "top";
    for (let part = 0; part <= seconds; ++part) {
      pen.textAlign = "center";
      const x = MARGIN.left + (inner.width * part) / seconds;
      pen.fillText(part === seconds ? "now" : `${part - seconds} s`, x, MARGIN.top + inner.height + 6);
    }
  }
}
