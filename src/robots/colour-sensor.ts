/** Colour sensors that any robot may carry: one that looks at the floor at its front edge, one that looks ahead. */
import type { Rgb } from '#core/rgb';
import type { Vec } from '#core/geometry';
import { attachTcs34725, levelsOf, TCS34725_ADDRESSES, type Light, type Look } from '#devices/tcs34725';
import type { Cone } from '#world/probes/distance-cone';
import { scaled } from './sonar';
import type { ColourState, Robot, RobotContext, RobotType } from './robot';
import { colourNamed } from './colour-names';

/** Radius of what it sees of the floor from 10 mm above it: chosen, its field of view is about 45°. */
const SPOT_RADIUS_MM = 4.5;

/** Its view ahead, from 20 mm above the floor: chosen. Farther away than 60 mm its lamp shows nothing. */
const AHEAD: Cone = { openingRad: 0.2, rangeMm: 60, heightMm: 20 };

/** Distance in mm for which its levels are fitted, and how far behind it the light of its lamp comes from: chosen. */
const FITTED_MM = 10;
const LAMP_BEHIND_MM = 20;

/** Nothing is before it. */
const DARK: Look = { shares: [0, 0, 0], lamp: 0 };

/** The middle of the front edge of a robot, robot frame, at the size of the real one. */
export const frontOf = ({ mountMm, body }: Pick<RobotType, 'mountMm' | 'body'>): Vec =>
  mountMm ?? { x: Math.max(...body.outlineMm.flat().map(({ x }) => x)), y: 0 };

/** A robot with the colour sensors that its options say; without any, it is the same robot. */
export function withColourSensors(robot: Robot, type: RobotType, context: RobotContext): Robot {
  const { options, chassis, clock, board } = context;
  const sides = (['down', 'ahead'] as const).filter((side) => options[OPTION[side]] === 'tcs34725');
  if (sides.length === 0) return robot;
  const atMm = scaled(frontOf(type), context.scale);
  const looks = { down: () => lookDown(context, atMm), ahead: () => lookAhead(context, atMm) };
  // A second one on the same bus needs another address.
  const sensors = sides.map((side, place) => ({
    side,
    look: looks[side],
    chip: attachTcs34725(clock, board.i2c, TCS34725_ADDRESSES[place === 0 ? 0 : 1], looks[side]),
  }));
  const colours = (): readonly ColourState[] =>
    sensors.map(({ side, look }) => stateOf(side, look(), chassis.toWorld(atMm)));
  return {
    ...robot,
    state: () => ({ ...robot.state(), colours: colours() }),
    step: () => {
      robot.step();
      for (const { chip } of sensors) chip.sample();
    },
    detach: () => {
      robot.detach();
      for (const { chip } of sensors) chip.stop();
    },
  };
}

const OPTION = { down: 'colour', ahead: 'colourAhead' } as const;

const lookDown = ({ light }: RobotContext, atMm: Vec): Look => ({ shares: light(atMm, SPOT_RADIUS_MM), lamp: 1 });

function lookAhead({ lightAhead }: RobotContext, atMm: Vec): Look {
  const hit = lightAhead(atMm, AHEAD);
  if (hit === null) return DARK;
  const far = (LAMP_BEHIND_MM + FITTED_MM) / (LAMP_BEHIND_MM + Math.max(hit.distanceMm, FITTED_MM));
  return { shares: hit.light, lamp: far * far };
}

/** Its display: the colour of what it sees, and its name. */
function stateOf(side: ColourState['side'], look: Look, atMm: Vec): ColourState {
  const [clear, red, green, blue] = levelsOf(look).map(Math.round);
  const raw = [clear ?? 0, red ?? 0, green ?? 0, blue ?? 0] as const;
  return { side, atMm, raw, color: shown(look.shares), ...colourNamed(raw) };
}

const shown = (shares: Light): Rgb => {
  const byte = (share: number): number => Math.min(255, Math.round(300 * share));
  return [byte(shares[0]), byte(shares[1]), byte(shares[2])];
};
