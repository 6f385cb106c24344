import type { Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import type { RobotState } from '#robots/robot';
import type { ArenaRobot, RobotLook } from '../model/arena-model';
import { attachmentPainter } from './draw-attachments';
import { bumperSprites } from './draw-bumper';
import { drawGlow, floorLight, glowOf } from '../../../kit/drawing/draw-glow';
import { ledOpacity } from '../../board/drawing/led-brightness';
import type { Palette } from '../model/palette';
import type { Box, ColourLight, RobotDrawing, Spot } from './robot-drawing';
import { HELD_SIZE, type RobotPainting } from './robot-painting';
import type { RobotSprite } from './robot-sprite';
import { toPx, type View } from '../view/view-transform';

/** The appearance of the robot. */
export interface RobotAppearance {
  /** 25 levels 0 … 9. */
  readonly display: ArrayLike<number>;
  /** Relative to the real robot. */
  readonly scale: number;
  /** In the hand: a little higher above the floor. */
  readonly held: boolean;
}

/** Radius of the robot's picture around its origin, light and shadow included, in mm of the real robot. */
export function paintedRadiusMm(drawing: RobotDrawing): number {
  const { x, y, width, height } = drawing.viewBox;
  const corner = Math.hypot(Math.max(-x, x + width), Math.max(-y, y + height));
  const lights = drawing.rgb.map((light) => Math.hypot(light.x, light.y) + light.radius * reachOf(light));
  return Math.max(corner + 10, ...lights) * HELD_SIZE;
}

/** Ratio of the radius of a colour light's glow to its circle in the drawing. */
const reachOf = ({ isOnTop }: ColourLight): number => (isOnTop ? 3 : 1.75);

/**
 * Draws the robot: shadow, light on the floor, body, its lights, the treads of its wheels, and attachments over its
 * front.
 */
export function drawRobot(
  context: CanvasRenderingContext2D,
  view: View,
  ratio: number,
  robot: ArenaRobot,
  painting: RobotPainting,
  appearance: RobotAppearance,
  palette: Palette,
): void {
  const { drawing, look } = painting;
  const at = toPx(view, { x: robot.pose.xMm, y: robot.pose.yMm });
  const size = view.pxPerMm * appearance.scale * (appearance.held ? HELD_SIZE : 1);
  const attachments = attachmentPainter(robot.state, painting);
  const sprite = (attachments?.bodySprites(robot, painting) ?? painting.sprites).at(size * ratio);
  const bumper = bumperSprites(painting, robot.state, size * ratio);
  const enter = (around: CanvasRenderingContext2D, shift: Vec): void => {
    around.save();
    around.translate(shift.x, shift.y);
    around.rotate(Math.PI / 2 - robot.pose.headingRad);
    around.scale(size, size);
  };
  const still = (around: CanvasRenderingContext2D): void => {
    if (sprite === null) return;
    drawShadows(around, enter, sprite, bumper, { size, held: appearance.held });
    enter(around, HERE);
    drawColours(around, drawing, robot.state, { onTop: false });
    for (const half of bumper) drawInto(around, half.sprite.body, drawing.viewBox, half.pushedMm);
    drawInto(around, sprite.body, drawing.viewBox);
    drawLights(around, drawing, robot, appearance.display);
    around.restore();
  };
  const lights = lightsOf(robot, appearance.display);
  const of = [sprite, appearance.held, ...bumper.flatMap((half) => [half.sprite, half.pushedMm]), ...lights];
  const reachPx = paintedRadiusMm(drawing) * size;
  painting.turned.draw(context, at, reachPx, { headingRad: robot.pose.headingRad, size, ratio, of }, still);
  enter(context, at);
  if (sprite === null) drawPlainBody(context, look, palette);
  else drawTreads(context, painting, robot, size * ratio);
  context.restore();
  attachments?.drawFront(context, view, ratio, { robot, painting, ...appearance });
}

const HERE: Vec = { x: 0, y: 0 };

/** Everything that shines: glows cost as much as the rest of a robot, so they are cached with its body. */
const lightsOf = ({ state }: ArenaRobot, display: ArrayLike<number>): readonly unknown[] => [
  ...state.rgb.flat(),
  ...state.lamps.flat(),
  ...state.lineSensors.map(({ bright }) => bright),
  state.leds.left,
  state.leds.right,
  ...Array.from(display),
];

/** Shadows fall a little to the right and below, at any heading of the robot. */
function drawShadows(
  context: CanvasRenderingContext2D,
  enter: (context: CanvasRenderingContext2D, shift: Vec) => void,
  sprite: RobotSprite,
  bumper: ReturnType<typeof bumperSprites>,
  { size, held }: { readonly size: number; readonly held: boolean },
): void {
  const height = held ? 9 : 3;
  enter(context, { x: 0.4 * height * size, y: height * size });
  context.globalAlpha = held ? 0.26 : 0.34;
  drawInto(context, sprite.shadow, sprite.shadowBox);
  for (const half of bumper) drawInto(context, half.sprite.shadow, half.sprite.shadowBox, half.pushedMm);
  context.restore();
}

function drawLights(
  context: CanvasRenderingContext2D,
  drawing: RobotDrawing,
  { state }: ArenaRobot,
  display: ArrayLike<number>,
): void {
  for (const sensor of state.lineSensors) {
    const spot = sensor.bright ? drawing.line.get(sensor.name) : undefined;
    if (spot !== undefined) drawLineLight(context, spot);
  }
  drawColours(context, drawing, state, { onTop: true });
  drawDisplay(context, drawing.display, display);
  drawRedLight(context, drawing.leds.left, state.leds.left);
  drawRedLight(context, drawing.leds.right, state.leds.right);
  drawLamp(context, drawing.lamps.left, state.lamps[0]);
  drawLamp(context, drawing.lamps.right, state.lamps[1]);
}

function drawTreads(
  context: CanvasRenderingContext2D,
  { treads, drawing: { wheels } }: RobotPainting,
  { wheelTurnRad: [left, right] }: ArenaRobot,
  pixelsPerMm: number,
): void {
  if (wheels.left !== null) treads.draw(context, wheels.left, left, pixelsPerMm);
  if (wheels.right !== null) treads.draw(context, wheels.right, right, pixelsPerMm);
}

function drawInto(context: CanvasRenderingContext2D, image: HTMLCanvasElement, box: Box, backMm = 0): void {
  context.drawImage(image, box.x, box.y + backMm, box.width, box.height);
}

/** Draws the colour lights under the body or those on top of it. */
function drawColours(
  context: CanvasRenderingContext2D,
  { rgb }: RobotDrawing,
  state: RobotState,
  { onTop }: { readonly onTop: boolean },
): void {
  rgb.forEach((light, i) => {
    const shown = state.rgb[i];
    if (shown === undefined || light.isOnTop !== onTop) return;
    const { color, alpha } = floorLight(shown);
    drawGlow(context, light, light.radius * reachOf(light), color, alpha);
    if (!onTop || alpha === 0) return;
    context.globalAlpha = alpha;
    disc(context, light, light.radius, `rgb(${color.join()})`);
    context.globalAlpha = 1;
  });
}

const blueGlow = glowOf([74, 184, 255]);
const redGlow = glowOf([255, 45, 34]);

function drawLineLight(context: CanvasRenderingContext2D, spot: Spot): void {
  blueGlow(context, spot, spot.radius * 2.4, 0.75);
  disc(context, spot, spot.radius, '#ffffff');
  disc(context, spot, spot.radius * 0.84, '#4fc3ff');
  disc(context, { x: spot.x - spot.radius * 0.22, y: spot.y - spot.radius * 0.25 }, spot.radius * 0.36, '#d4f1ff');
}

function drawRedLight(context: CanvasRenderingContext2D, spot: Spot | null, brightness: number): void {
  if (spot === null || brightness <= 0) return;
  redGlow(context, { x: spot.x, y: spot.y - 1 }, spot.radius * 5.4, 0.95 * brightness);
  disc(context, spot, spot.radius * 1.24, '#ffd9d3');
  disc(context, spot, spot.radius, '#ff4a3d');
  disc(context, { x: spot.x - spot.radius * 0.25, y: spot.y - spot.radius * 0.3 }, spot.radius * 0.42, '#ffe3de');
}

function drawLamp(context: CanvasRenderingContext2D, spot: Spot | null, color: Rgb | undefined): void {
  if (spot === null || color === undefined) return;
  const light = floorLight(color);
  if (light.alpha === 0) return;
  drawGlow(context, { x: spot.x, y: spot.y - 1 }, spot.radius * 5.4, light.color, light.alpha);
  disc(context, spot, spot.radius * 1.24, '#ffffff');
  disc(context, spot, spot.radius, `rgb(${light.color.join()})`);
  disc(context, { x: spot.x - spot.radius * 0.25, y: spot.y - spot.radius * 0.3 }, spot.radius * 0.42, '#ffffffcc');
}

function drawDisplay(context: CanvasRenderingContext2D, lights: readonly Box[], levels: ArrayLike<number>): void {
  lights.forEach((light, i) => {
    const opacity = ledOpacity(levels[i] ?? 0);
    if (opacity === 0) return;
    context.globalAlpha = 0.45 * opacity;
    context.fillStyle = '#ff3b2f';
    context.fillRect(light.x - 0.7, light.y - 0.5, light.width + 1.4, light.height + 1);
    context.globalAlpha = opacity;
    context.fillStyle = '#ff6a58';
    context.fillRect(light.x, light.y, light.width, light.height);
  });
  context.globalAlpha = 1;
}

/** The bare outline with an arrow, until the drawing has loaded. */
function drawPlainBody(context: CanvasRenderingContext2D, look: RobotLook, palette: Palette): void {
  context.fillStyle = palette.wall;
  for (const part of look.body.outlineMm) {
    context.beginPath();
    for (const corner of part) context.lineTo(-corner.y, -corner.x); // robot frame to drawing: front is up
    context.fill();
  }
  context.strokeStyle = palette.fixedInk;
  context.lineWidth = 3;
  context.beginPath();
  context.moveTo(-10, -30);
  context.lineTo(0, -42);
  context.lineTo(10, -30);
  context.stroke();
}

function disc(context: CanvasRenderingContext2D, at: Vec, radius: number, color: string): void {
  context.fillStyle = color;
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.fill();
}
