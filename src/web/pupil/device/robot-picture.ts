import { readRobotDrawing, type Box } from '../arena/robot/robot-drawing';

/** A robot's portrait: its drawing as an address for an image, and the lights to be drawn with it. In mm, front up. */
export interface RobotPortrait {
  /** The box that the picture shows. */
  readonly box: Box;
  /** Place of the drawing in it. */
  readonly body: Box;
  readonly href: string;
  readonly lights: readonly Light[];
}

/** A light and the glow around it. */
export interface Light {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly color: string;
  /** Under the body: only its glow on the floor is seen. */
  readonly below: boolean;
}

// Chosen by eye: one colour for each colour light, in the order of their numbers; a fifth one begins anew.
const COLORS = ['#00b4ff', '#5b5bff', '#ff3d9a', '#18c964'];
const RED = '#ff2d2d';
const LAMP = '#38e0ff';
const UNDERGLOW_REACH = 1.75; // as in the arena
const LED_REACH = 3;
const MARGIN_MM = 8; // room for the light around the body; what reaches farther fades away

/** Hides the circles that only mark the colour lights. */
const NO_PLACES = '<style>[id^="rgb-"]{display:none}</style>';

/** The portrait for the text of a robot.svg; without `lit` all lights are off. */
export function robotPicture(svg: string, lit: boolean): RobotPortrait {
  const drawing = readRobotDrawing(svg);
  const body = drawing.viewBox;
  const margin = lit ? MARGIN_MM : 0;
  const colours = drawing.rgb.map(({ isOnTop, radius, ...at }, index) => ({
    ...at,
    radius: radius * (isOnTop ? LED_REACH : UNDERGLOW_REACH),
    color: COLORS[index % COLORS.length] ?? RED,
    below: !isOnTop,
  }));
  const leds = [drawing.leds.left, drawing.leds.right]
    .filter((spot) => spot !== null)
    .map((spot) => ({ ...spot, radius: spot.radius * LED_REACH, color: RED, below: false }));
  const lamps = [drawing.lamps.left, drawing.lamps.right]
    .filter((spot) => spot !== null)
    .map((spot) => ({ ...spot, radius: spot.radius * LED_REACH, color: LAMP, below: false }));
  const lights = lit ? [...colours, ...leds, ...lamps] : [];
  return {
    box: {
      x: body.x - margin,
      y: body.y - margin,
      width: body.width + 2 * margin,
      height: body.height + 2 * margin,
    },
    body,
    href: `data:image/svg+xml,${encodeURIComponent(svg.replace(/<svg\b[^>]*>/, (root) => root + NO_PLACES))}`,
    lights,
  };
}
