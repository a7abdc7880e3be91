#include "query/ball_viewer.h"

#include <cmath>
#include <iterator>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace mdbd {
namespace {

constexpr std::string_view viewer = R"(<dialog id="viewer" aria-label="Balls">
<div class="top"><p class="soft">Drag, or use the arrow keys, to turn both.<span id="legend"> Orange: the balls that differ the most.</span></p><button type="button" id="close">Close</button></div>
<div class="pair">
<figure><figcaption></figcaption><canvas tabindex="0" role="img" aria-label="Balls of the query"></canvas></figure>
<figure><figcaption></figcaption><canvas tabindex="0" role="img" aria-label="Balls of the match"></canvas></figure>
</div>
</dialog>
<script>
//<![CDATA[
(() => {
  "use strict";
  const shapes = JSON.parse(document.getElementById("balls").textContent);
  const dialog = document.getElementById("viewer");
  const legend = document.getElementById("legend");
  const figures = [...dialog.querySelectorAll("figure")];
  const views = figures.map((figure) => ({
    figure, canvas: figure.querySelector("canvas"), balls: [], differ: new Set(),
  }));

  // Rows: right, up, towards the viewer; at first as in the thumbnails.
  const oblique = [0.8064, 0.5914, 0, -0.2798, 0.3816, 0.8810, 0.5210, -0.7104, 0.4732];
  let axes = oblique;

  function product(a, b) {
    const c = [];
    for (let row = 0; row < 3; ++row) {
      for (let column = 0; column < 3; ++column) {
        let sum = 0;
        for (let k = 0; k < 3; ++k) sum += a[3 * row + k] * b[3 * k + column];
        c.push(sum);
      }
    }
    return c;
  }

  function turn(right, down) {
    const [c, s, d, t] = [Math.cos(right), Math.sin(right), Math.cos(down), Math.sin(down)];
    axes = product([1, 0, 0, 0, d, -t, 0, t, d], product([c, 0, s, 0, 1, 0, -s, 0, c], axes));
    draw();
  }

  // A lit sphere, drawn once and then scaled.
  function sphere(dark, middle, bright) {
    const image = document.createElement("canvas");
    image.width = image.height = 128;
    const context = image.getContext("2d");
    const shade = context.createRadialGradient(46, 42, 4, 60, 60, 70);
    shade.addColorStop(0, bright);
    shade.addColorStop(0.5, middle);
    shade.addColorStop(1, dark);
    context.fillStyle = shade;
    context.beginPath();
    context.arc(64, 64, 63, 0, 2 * Math.PI);
    context.fill();
    return image;
  }
  const plain = sphere("#33496a", "#8ea3bd", "#e6eef6");
  const marked = sphere("#8a3d08", "#e8833a", "#ffe3c8");

  function drawView(view) {
    if (view.figure.hidden) return;
    const side = Math.round(view.canvas.clientWidth * (window.devicePixelRatio || 1));
    view.canvas.width = view.canvas.height = side;
    const context = view.canvas.getContext("2d");
    const scale = side / 2 / view.extent;
    const seen = [];
    for (let i = 0; i < view.balls.length; i += 4) {
      const [x, y, z, r] = view.balls.slice(i, i + 4);
      const along = (row) => axes[row] * x + axes[row + 1] * y + axes[row + 2] * z;
      seen.push([along(0), along(3), along(6), r, view.differ.has(i / 4 + 1)]);
    }
    seen.sort((a, b) => a[2] - b[2]);
    for (const [x, y, , r, differs] of seen) {
      const size = Math.max(2 * r * scale, 1);
      context.drawImage(differs ? marked : plain, side / 2 + (x - r) * scale,
                        side / 2 - (y + r) * scale, size, size);
    }
  }
  const draw = () => views.forEach(drawView);

  function show(view, name, caption, differ) {
    view.balls = shapes[name] || [];
    view.differ = new Set(differ);
    view.extent = 1;
    for (let i = 0; i < view.balls.length; i += 4) {
      const [x, y, z, r] = view.balls.slice(i, i + 4);
      view.extent = Math.max(view.extent, Math.hypot(x, y, z) + r);
    }
    view.figure.querySelector("figcaption").textContent = caption;
  }

  function open(button) {
    const { query, match, differ, caption, asked } = button.dataset;
    const numbers = (differ || "").split(" ").filter(Boolean).map(Number);
    views[0].figure.hidden = query === match;
    legend.hidden = numbers.length === 0;
    show(views[0], query, asked, numbers);
    show(views[1], match, caption, numbers);
    axes = oblique;
    dialog.showModal();
    draw();
  }

  for (const button of document.querySelectorAll("[data-match]")) {
    button.addEventListener("click", () => open(button));
  }
  document.getElementById("close").addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
  window.addEventListener("resize", draw);
  for (const { canvas } of views) {
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) turn(event.movementX / 120, event.movementY / 120);
    });
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15] }[event.key];
      if (!step) return;
      event.preventDefault();
      turn(...step);
    });
  }
})();
//]]>
</script>
)";

}  // namespace

std::string balls_to_json(const std::vector<Ball>& balls, double scale) {
  Eigen::AlignedBox3d box;
  for (const Ball& ball : balls) box.extend(ball.center);
  std::string json = "[";
  for (const Ball& ball : balls) {
    const Eigen::Vector3d center = (ball.center - box.center()) * (1000.0 / scale);
    fmt::format_to(std::back_inserter(json), "{}{:.0f},{:.0f},{:.0f},{:.0f}",
                   json.size() > 1 ? "," : "", center.x(), center.y(), center.z(),
                   std::ceil(ball.radius * 1000.0 / scale));
  }
  return json + ']';
}

std::string_view ball_viewer() { return viewer; }

}  // namespace mdbd
