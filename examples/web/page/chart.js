// The chart: milliseconds of the last steps of both worlds, and of their broad phases.

const SHOWN = 300;

/** The height of the chart, relative to the 95th percentile of the steps. Slower steps are cut off. */
const HEADROOM = 1.3;

/** Draws the last steps of both worlds; each is a list of `{ step, broad }`. */
export function drawChart(canvas, sides) {
  const style = getComputedStyle(canvas);
  const ratio = window.devicePixelRatio;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);

  const times = Object.values(sides).flatMap((steps) => steps.slice(-SHOWN).map(({ step }) => step));
  if (times.length === 0) return;
  const top = HEADROOM * times.sort((a, b) => a - b)[Math.floor(times.length * 0.95)];
  const y = (ms) => height - 1 - Math.min(ms / top, 1) * (height - 2);

  context.lineWidth = 1;
  const spacing = gridSpacing(top);
  for (let ms = 0; ms <= top; ms += spacing) {
    context.strokeStyle = style.getPropertyValue("--line");
    context.beginPath();
    context.moveTo(0, y(ms));
    context.lineTo(width, y(ms));
    context.stroke();
  }
  for (const [name, steps] of Object.entries(sides)) {
    const shown = steps.slice(-SHOWN);
    context.strokeStyle = style.getPropertyValue(`--${name}`);
    for (const [part, thickness] of [["step", 2], ["broad", 1]]) {
      context.lineWidth = thickness;
      context.beginPath();
      shown.forEach((sample, index) => {
        context.lineTo(((SHOWN - shown.length + index) / (SHOWN - 1)) * width, y(sample[part]));
      });
      context.stroke();
    }
  }

  // Above the lines, with an edge in the colour of the page.
  context.font = `12px ${style.fontFamily}`;
  context.lineWidth = 4;
  context.strokeStyle = style.getPropertyValue("--page");
  context.fillStyle = style.getPropertyValue("--faint");
  for (let ms = spacing; ms <= top; ms += spacing) {
    if (y(ms) <= 15) break;
    context.strokeText(`${+ms.toPrecision(3)} ms`, 2, y(ms) - 3);
    context.fillText(`${+ms.toPrecision(3)} ms`, 2, y(ms) - 3);
  }
}

/** The distance between grid lines: 1, 2 or 5 times a power of ten, so that there are two to five lines. */
function gridSpacing(top) {
  const power = 10 ** Math.floor(Math.log10(top / 2));
  return [5, 2, 1].map((factor) => factor * power).find((spacing) => top / spacing >= 2) ?? power;
}
