#include "host/pictures/report/report_style.hpp"

namespace brdftab {

const std::string_view report_style = R"css(
:root { color-scheme: light dark; --page: #ffffff; --text: #1a1a1a; --faint: #5f5f5f;
  --line: #dcdcdc; --accent: #0072b2; }
@media (prefers-color-scheme: dark) {
  :root { --page: #14171c; --text: #e8e8e8; --faint: #a5a8ac; --line: #343940; --accent: #4da6e0; }
}
body { margin: 0 auto; padding: 1.5rem 1.25rem 4rem; max-width: 62rem; background: var(--page);
  color: var(--text); font: 16px/1.5 Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 0.6rem; padding-top: 0.6rem; border-top: 1px solid var(--line); }
p, figcaption { max-width: 46rem; }
figure { margin: 1.2rem 0; break-inside: avoid; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption, .faint { color: var(--faint); font-size: 0.9rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.9rem; margin: 0.6rem 0; }
th, td { text-align: left; vertical-align: top;
  padding: 0.22rem 1.1rem 0.22rem 0; border-bottom: 1px solid var(--line); }
th { font-weight: 600; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
pre { overflow-x: auto; padding: 0.7rem 0.9rem; border: 1px solid var(--line);
  border-radius: 4px; font-size: 0.85rem; }
pre.command { white-space: pre-wrap; overflow-wrap: anywhere; }
.warning { border-left: 4px solid #d55e00; padding-left: 0.8rem; }
.explorer { display: grid; grid-template-columns: 57fr 40fr; gap: 1rem 1.5rem; align-items: start; }
.explorer canvas { width: 100%; height: auto; display: block; touch-action: pan-y; }
.controls { grid-column: 1 / -1; display: flex; flex-wrap: wrap; gap: 0.4rem 1.2rem; align-items: center; }
.controls input[type=range] { flex: 1 1 16rem; accent-color: var(--accent); }
.controls output { min-width: 6.5em; font-variant-numeric: tabular-nums; }
#reading { min-height: 1.5em; font-variant-numeric: tabular-nums; }
@media (max-width: 45rem) { .explorer { grid-template-columns: 1fr; } }
.explorer > * { min-width: 0; }
@media print { body { max-width: none; } .controls { display: none; } details { display: block; } }
)css";

const std::string_view report_script = R"js(
"use strict";
(() => {
const element = (id) => document.getElementById(id);
const axes = JSON.parse(element("axes").textContent);
const scale = JSON.parse(element("scale").textContent);
const bytes = Uint8Array.from(atob(element("samples").textContent.trim()), (c) => c.charCodeAt(0));
const samples = new Float32Array(bytes.buffer);
const thetaI = axes.theta_i, thetaS = axes.theta_s;
const rows = thetaS.length, columns = axes.phi.length;
const degree = Math.PI / 180;

// The azimuths once around, each with the column of the node that has its value. Where an azimuth has no
// node, its mirror image in the plane of incidence serves, because f is even in phi.
const turned = (phi) => { const t = ((phi % 360) + 360) % 360; return t > 360 - 1e-9 ? 0 : t; };
const circle = [];
for (const sign of [1, -1])
  axes.phi.forEach((phi, column) => {
    const at = turned(sign * phi);
    if (!circle.some((other) => Math.abs(other.phi - at) < 1e-9)) circle.push({phi: at, column});
  });
circle.sort((a, b) => a.phi - b.phi);
circle.push({phi: circle[0].phi + 360, column: circle[0].column});

// The nodes around a direction, and how far it is from one to the next. Beyond the nodes there is null.
function cell(theta, phi) {
  if (theta < thetaS[0] || theta > thetaS[rows - 1]) return null;
  let low = 0, high = rows - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (thetaS[middle] <= theta) low = middle; else high = middle;
  }
  const down = high > low ? (theta - thetaS[low]) / (thetaS[high] - thetaS[low]) : 0;
  let angle = turned(phi);
  if (angle < circle[0].phi) angle += 360;
  let left = 0, right = circle.length - 1;
  while (right - left > 1) {
    const middle = (left + right) >> 1;
    if (circle[middle].phi <= angle) left = middle; else right = middle;
  }
  const along = (angle - circle[left].phi) / (circle[right].phi - circle[left].phi);
  return {low, high, down, left: circle[left].column, right: circle[right].column, along};
}

let set = 0, incidence = 0;
const at = (row, column) => samples[((set * thetaI.length + incidence) * rows + row) * columns + column];

// f between the nodes, linear in ln f where it is positive.
function value(c) {
  const corners = [at(c.low, c.left), at(c.low, c.right), at(c.high, c.left), at(c.high, c.right)];
  const weights = [(1 - c.down) * (1 - c.along), (1 - c.down) * c.along,
                   c.down * (1 - c.along), c.down * c.along];
  const logarithmic = corners.every((f) => f > 0);
  let sum = 0;
  for (let k = 0; k < 4; ++k) sum += weights[k] * (logarithmic ? Math.log(corners[k]) : corners[k]);
  return logarithmic ? Math.exp(sum) : sum;
}

// Where a value lies on the scale: 0 at its low end, 1 at its high end.
const share = (f) => f > 0 ? Math.log(f / scale.low) / Math.log(scale.high / scale.low) : -1;
const position = (f) => Math.min(Math.max(share(f), 0), 1);
const colours = scale.colours.map((hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)));

const map = element("map"), cut = element("cut");
// The disc of the map has these sizes in units of the page; a unit has `density` pixels.
const side = 420, radius = side / 2, left = 52, top = 14;
const density = 2;
const pixels = side * density;
const disc = document.createElement("canvas");
disc.width = disc.height = pixels;
const image = disc.getContext("2d").createImageData(pixels, pixels);
const reach = Math.sin(thetaS[rows - 1] * degree) + 1 / pixels;
const cells = new Array(pixels * pixels).fill(null);
for (let row = 0; row < pixels; ++row)
  for (let column = 0; column < pixels; ++column) {
    const x = (column + 0.5) / pixels * 2 - 1, y = 1 - (row + 0.5) / pixels * 2, r = Math.hypot(x, y);
    if (r < reach && r < 1)
      cells[row * pixels + column] =
        cell(Math.min(Math.asin(r) / degree, thetaS[rows - 1]), Math.atan2(y, x) / degree);
  }

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function prepared(canvas, width, height) {
  canvas.width = width * density;
  canvas.height = height * density;
  const context = canvas.getContext("2d");
  context.scale(density, density);
  context.font = "14px Helvetica, Arial, 'DejaVu Sans', sans-serif";
  context.fillStyle = style("--text");
  context.strokeStyle = style("--faint");
  context.lineWidth = 1;
  return context;
}

function tickText(context, tick, x, y) {
  // In a label such as 5·10^{−3} the power is raised.
  const [whole, base, power] = tick.match(/^(.*?)(?:\^\{(.*)\})?$/);
  context.fillText(base, x, y);
  if (power) {
    const width = context.textAlign === "right" ? 0 : context.measureText(base).width;
    context.save();
    context.font = "10px Helvetica, Arial, 'DejaVu Sans', sans-serif";
    context.fillText(power, x + width, y - 6);
    context.restore();
  }
}

function drawMap() {
  for (let k = 0; k < cells.length; ++k) {
    const pixel = 4 * k;
    if (!cells[k]) { image.data[pixel + 3] = 0; continue; }
    const colour = colours[Math.round(position(value(cells[k])) * (colours.length - 1))];
    image.data.set(colour, pixel);
    image.data[pixel + 3] = 255;
  }
  disc.getContext("2d").putImageData(image, 0, 0);
  const context = prepared(map, side + left + 96, side + top + 52);
  const cx = left + radius, cy = top + radius;
  context.drawImage(disc, left, top, side, side);
  const circleAt = (x, y, r) => {
    context.beginPath(); context.arc(x, y, r, 0, 2 * Math.PI); context.stroke();
  };
  context.save();
  context.strokeStyle = "rgba(255, 255, 255, 0.4)";
  for (const theta of [30, 60]) circleAt(cx, cy, radius * Math.sin(theta * degree));
  context.beginPath(); context.moveTo(cx - radius, cy); context.lineTo(cx + radius, cy); context.stroke();
  context.restore();
  circleAt(cx, cy, radius);
  const mirror = radius * Math.sin(thetaI[incidence] * degree);
  for (const [colour, width] of [["#000000", 3.4], ["#ffffff", 1.6]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(cx + mirror + 5 * dx, cy + 5 * dy);
      context.lineTo(cx + mirror + 11 * dx, cy + 11 * dy);
    }
    context.stroke();
    circleAt(cx - mirror, cy, 6);
  }
  context.strokeStyle = style("--faint");
  context.lineWidth = 1;
  context.textAlign = "center";
  for (const tick of [-1, 0, 1])
    context.fillText(String(tick).replace("-", "−"), cx + radius * tick, top + side + 20);
  context.fillText("sin θₛ cos φ", cx, top + side + 42);
  context.textAlign = "right";
  for (const tick of [-1, 0, 1])
    context.fillText(String(tick).replace("-", "−"), left - 8, cy - radius * tick + 5);
  context.save();
  context.translate(16, cy); context.rotate(-Math.PI / 2); context.textAlign = "center";
  context.fillText("sin θₛ sin φ", 0, 0);
  context.restore();
  const barX = left + side + 18;
  for (let k = 0; k < side; ++k) {
    const colour = colours[Math.round((1 - k / (side - 1)) * (colours.length - 1))];
    context.fillStyle = `rgb(${colour})`;
    context.fillRect(barX, top + k, 16, 1.5);
  }
  context.strokeRect(barX, top, 16, side);
  context.fillStyle = style("--text");
  context.textAlign = "left";
  for (const tick of scale.ticks) {
    const y = top + side * (1 - position(tick.value));
    context.beginPath(); context.moveTo(barX + 16, y); context.lineTo(barX + (tick.label ? 21 : 19), y);
    context.stroke();
    if (tick.label) tickText(context, tick.label, barX + 25, y + 5);
  }
  context.fillText("sr⁻¹", barX, top + side + 20);
}

function drawCut() {
  const width = 400, height = 396;
  const box = {left: 62, top: 14, right: width - 12, bottom: height - 48};
  const context = prepared(cut, width, height);
  const x = (theta) => box.left + (theta + 90) / 180 * (box.right - box.left);
  const y = (f) => box.bottom - share(f) * (box.bottom - box.top);
  context.textAlign = "center";
  for (const theta of [-90, -60, -30, 0, 30, 60, 90]) {
    context.strokeStyle = style("--line");
    context.beginPath(); context.moveTo(x(theta), box.top); context.lineTo(x(theta), box.bottom);
    context.stroke();
    context.fillText(String(theta).replace("-", "−"), x(theta), box.bottom + 20);
  }
  context.fillText("θₛ in the plane of incidence, degrees", (box.left + box.right) / 2, box.bottom + 42);
  context.textAlign = "left";
  for (const tick of scale.ticks) {
    if (!tick.label) continue;
    context.strokeStyle = style("--line");
    context.beginPath(); context.moveTo(box.left, y(tick.value)); context.lineTo(box.right, y(tick.value));
    context.stroke();
    tickText(context, tick.label, box.left - 44, y(tick.value) + 5);
  }
  context.save();
  context.translate(13, (box.top + box.bottom) / 2); context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText("BRDF, sr⁻¹", 0, 0);
  context.restore();
  context.strokeStyle = style("--faint");
  context.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  const points = [];
  for (const [phi, sign] of [[180, -1], [0, 1]]) {
    const node = circle.find((azimuth) => Math.abs(azimuth.phi - phi) < 1e-9);
    if (!node) continue;
    thetaS.forEach((theta, row) => {
      if (theta > 0 || sign > 0) points.push([sign * theta, at(row, node.column)]);
    });
  }
  points.sort((a, b) => a[0] - b[0]);
  context.save();
  context.beginPath(); context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.clip();
  context.strokeStyle = context.fillStyle = style("--accent");
  context.lineWidth = 1.6;
  context.beginPath();
  points.forEach(([theta, f], k) => k ? context.lineTo(x(theta), y(f)) : context.moveTo(x(theta), y(f)));
  context.stroke();
  for (const [theta, f] of points) {
    context.beginPath(); context.arc(x(theta), y(f), 1.7, 0, 2 * Math.PI); context.fill();
  }
  context.restore();
}

function draw() {
  element("theta_i").value = `${thetaI[incidence]}°`;
  drawMap();
  drawCut();
}

const slider = element("slider");
slider.max = thetaI.length - 1;
const offMiddle = (k) => Math.abs(thetaI[k] - 45);
incidence = thetaI.reduce((best, theta, k) => offMiddle(k) < offMiddle(best) ? k : best, 0);
slider.value = incidence;
slider.addEventListener("input", () => { incidence = Number(slider.value); draw(); });
const sets = element("sets");
axes.sets.forEach((name, k) => sets.add(new Option(name, k)));
sets.parentElement.hidden = axes.sets.length < 2;
sets.addEventListener("change", () => { set = Number(sets.value); draw(); });
map.addEventListener("pointermove", (event) => {
  const bounds = map.getBoundingClientRect(), zoom = (side + left + 96) / bounds.width;
  const u = ((event.clientX - bounds.left) * zoom - left) / radius - 1;
  const v = 1 - ((event.clientY - bounds.top) * zoom - top) / radius;
  const r = Math.hypot(u, v);
  const theta = Math.asin(r) / degree, phi = Math.atan2(v, u) / degree;
  const c = r < 1 ? cell(theta, phi) : null;
  element("reading").textContent = c
    ? `θₛ = ${theta.toFixed(1)}°, φ = ${turned(phi).toFixed(1)}°: f = ${value(c).toPrecision(4)} sr⁻¹`
    : "";
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
draw();
})();
)js";

}  // namespace brdftab
