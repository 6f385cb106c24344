/** The Maqueen Plus V3's controller with what it drives by itself: motors, lamps, measured moves, line patrol. */
import type { Rgb } from '#core/rgb';
import type { Stop } from '#core/stop';
import type { I2cTarget } from '#board/wires/i2c-bus';
import { BOTH_SIDES } from '#devices/dc-motor';
import type { Touched } from '#devices/i2c-registers';
import { lightEyes } from '../light-eyes';
import type { LineRow } from '../line-row';
import { mountMotors } from '../mounting';
import { bodyOf, type RobotContext, type RobotState } from '../robot';
import { CONTROLLER_ADDRESS, createController, type ControllerParts } from './controller';
import type { LineName } from '../maqueen-plus-frame';
import { createMover, type Move } from './moves';
import { Patrol, type PatrolSettings } from './patrol';
import { maqueenPlusV3 as type } from './type';
import { createWheels } from './wheels';

/** Time for which it does not answer after a reset. Chosen: drivers wait 100 ms without asking (DFRobot) or ask (K10). */
const RESET_US = 80_000;

/** Chosen: a light level of 0 … 255 as 10 bits; by itself 508, a room. */
const LIGHT_PER_LEVEL = 4;

/** Chosen: near the front edge, 70 mm apart. */
const LIGHT_EYES = lightEyes({ x: 60, y: 35 });

const DARK: Rgb = [0, 0, 0];

/** The chassis, as its robot sees it. */
export interface MountedChassis {
  readonly lamps: () => RobotState['lamps'];
  readonly duty: () => RobotState['duty'];
  /** Call it after each step of the world, and after the line sensors. */
  step(): void;
  readonly stop: Stop;
}

/** Puts the controller on the bus. */
export function mountChassis(context: RobotContext, line: LineRow<LineName>): MountedChassis {
  const motors = mountMotors(context);
  const own = ownDrive(context, line, () => controller.patrol());
  const lamps = createLamps(context);
  const parts: ControllerParts = {
    ...own.parts,
    isBright: line.isBright,
    brightness: line.reading,
    light: (side) => Math.round(context.lightLevel(LIGHT_EYES[side === 0 ? 'left' : 'right']) * LIGHT_PER_LEVEL),
    motors: (left, right, sides) => {
      own.drop();
      motors.set(left, right, sides);
    },
    lamps: lamps.set,
    startAnew: () => {
      parts.motors(0, 0, BOTH_SIDES);
      lamps.set(DARK, DARK, { first: 0, last: 1 });
      parts.clearDriven();
      controller = createController(parts);
      link.restart(controller.target);
    },
  };
  let controller = createController(parts);
  const link = linkTo(context, controller.target);
  return {
    lamps: lamps.colors,
    duty: motors.duty,
    step: own.step,
    stop: () => {
      link.stop();
      own.drop();
      motors.stop();
    },
  };
}

/** The controller's end of the bus. A restarted one is away for a moment. */
function linkTo({ board, clock }: RobotContext, first: I2cTarget) {
  let leave = board.i2c.attach(CONTROLLER_ADDRESS, first);
  let cancel: Stop = () => undefined;
  return {
    restart: (target: I2cTarget): void => {
      leave();
      cancel = clock.at(clock.nowUs + RESET_US, () => {
        leave = board.i2c.attach(CONTROLLER_ADDRESS, target);
      });
    },
    stop: (): void => {
      cancel();
      leave();
    },
  };
}

function createLamps({ onSet }: RobotContext) {
  let colors: readonly [Rgb, Rgb] = [DARK, DARK];
  return {
    colors: (): readonly Rgb[] => colors,
    set: (left: Rgb, right: Rgb, { first, last }: Touched): void => {
      colors = [left, right];
      if (first === 0) onSet?.('light-left', left.join());
      if (last === 1) onSet?.('light-right', right.join());
    },
  };
}

type OwnParts = Omit<ControllerParts, 'motors' | 'lamps' | 'isBright' | 'brightness' | 'light' | 'startAnew'>;

/** Moves and patrol, which the controller drives by itself; at most one of them runs. */
function ownDrive(context: RobotContext, line: LineRow<LineName>, settings: () => PatrolSettings) {
  const { onSet } = context;
  const { drive, wheels: bodyWheels } = bodyOf(type, context.options);
  const wheels = createWheels({ ...context, drive, radiusMm: bodyWheels[0].radiusMm });
  const mover = createMover(wheels, context.miss);
  const patrol = new Patrol(wheels, (sensor) => !line.isBright(sensor), settings);
  const tell = (value: string | number): void => {
    for (const side of BOTH_SIDES) onSet?.(`wheel-${side}`, value);
  };
  const parts: OwnParts = {
    ...wheels,
    startMove: (move) => {
      patrol.drop();
      mover.start(move);
      tell(nameOf(move));
    },
    stopMove: () => {
      if (!mover.isMoving()) return;
      mover.stop();
      tell(0);
    },
    isMoving: () => mover.isMoving(),
    startPatrol: () => {
      mover.drop();
      patrol.start();
      tell(`line ${String(settings().grade)}`);
    },
    stopPatrol: () => {
      if (!patrol.isOn()) return;
      patrol.stop();
      tell(0);
    },
    junction: () => patrol.junction(),
  };
  return {
    parts,
    drop: (): void => {
      mover.drop();
      patrol.drop();
      wheels.letGo();
    },
    step: (): void => {
      wheels.step();
      mover.step();
      patrol.step();
    },
  };
}

/** A move in a word and its measure, as one reads it beside the line that set it. */
const nameOf = (move: Move): string =>
  move.kind === 'distance'
    ? `${move.isForward ? '' : '−'}${String(move.cm)} cm`
    : `${move.isToTheRight ? '−' : ''}${String(move.deg)}°`;
