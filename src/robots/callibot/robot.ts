/**
 * Knotech Calli:bot 2E (also as 2 and 1): its wiring. Frame and units: see ../robot.ts. Where each number comes from:
 * SOURCES.md; CN = calliope-net/callibot2.
 *
 * Everything is on the I2C bus at the connector A0; see controller.ts for the bytes.
 *
 *      0x20  motors, servos S1 S2
 *      0x21  lights; line sensors, bumper, ultrasonic
 *      0x22  the same by registers, and line sensors in mV, encoders, supply voltage, type
 *      0x23 … 0x27  answer, do nothing
 */
import type { Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import { signedDuty, type Side } from '#devices/dc-motor';
import { FARTHEST_MM, NEAREST_MM } from '#devices/hc-sr04';
import { createRegisterMachine } from '#devices/i2c-registers';
import { mountLineRow, type LinePlace } from '../line-row';
import { mountMotors, mountServos, tellColors } from '../mounting';
import {
  bareState,
  noLights,
  type Robot,
  type RobotBuild,
  type RobotContext,
  type RobotLights,
  type RobotState,
} from '../robot';
import { mountSonar, SR04_CONE } from '../sonar';
import { createBumper } from './bumper';
import {
  createController,
  LIGHTS_ADDRESS,
  MOTORS_ADDRESS,
  REGISTERS_ADDRESS,
  SILENT_ADDRESSES,
  type Controller,
  type Model,
} from './controller';
import callibotPy from './library/callibot.py?raw';
import callibotmot from './library/callibotmot.py?raw';
import cbalarm from './library/cbalarm.py?raw';
import { callibot as type, SERVO_PORTS } from './type';

/** Chosen: below the nose, close enough together for both to see a line of 15 mm, the least recommended width. */
const LINE_SENSORS: readonly LinePlace<Side>[] = [
  { name: 'left', atMm: { x: 46, y: 6 } },
  { name: 'right', atMm: { x: 46, y: -6 } },
];
const LINE_SPOT_RADIUS_MM = 2.5; // chosen, as for the Maqueens: as wide as the sensor's housing
/** Output on black and on bare floor, linear in between: chosen, because no source has measured values; at most the supply. */
const LINE_MV = { black: 300, floor: 2800, most: 3300 } as const;

const SONAR_AT: Vec = { x: 65, y: 0 }; // chosen: where the cans end in the drawing

/** Three pulses a turn of the motor, a gear of 150 : 1: CN sensoren.ts. */
const PULSES_PER_RAD = 450 / (2 * Math.PI);

const COLOR_LIGHTS = 4;

export const callibotBuild: RobotBuild = {
  type,
  libraries: { 'callibot.py': callibotPy, 'callibotmot.py': callibotmot, 'cbalarm.py': cbalarm },
  attach,
};

function attach(context: RobotContext): Robot {
  const { chassis, options, onSet } = context;
  const tell = tellColors(context);
  const model = modelOf(options['model']);
  const servos = mountServos(context, type, SERVO_PORTS);
  const bumper = createBumper(context, fittingOf(context, model));
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const line = mountLineRow(context, LINE_SENSORS, { spotRadiusMm: LINE_SPOT_RADIUS_MM, ...LINE_MV });
  const leds: { left: 0 | 1; right: 0 | 1 } = { left: 0, right: 0 };
  const rgb: Rgb[] = Array.from({ length: COLOR_LIGHTS }, () => [0, 0, 0]);
  const motors = mountMotors(context);

  const controller = createController(
    {
      motors: (left, right, sides) =>
        motors.set(signedDuty(left.direction, left.power), signedDuty(right.direction, right.power), sides),
      servo: (port, angleDeg) => servos.set(port, angleDeg),
      redLight: (side, isLit) => {
        leds[side] = isLit ? 1 : 0;
        onSet?.(`light-${side}`, leds[side]);
      },
      colorLight: (index, color) => {
        rgb[index] = color;
        tell(index, color);
      },
      isBright: line.isBright,
      isPressed: (side) => bumper.read(side),
      lineMv: line.reading,
      distanceMm: () => measured(sonar.distanceMm(), options['echo'] === 'zero'),
      supplyMv: context.supplyMv,
      pulses: (side) => Math.trunc(chassis.wheelTurnRad(side === 'left' ? 0 : 1) * PULSES_PER_RAD),
    },
    model,
  );
  const stops = [...plugIn(context, controller), line.stop, servos.stop, () => bumper.stop(), motors.stop];

  const lights = (): RobotLights => ({ ...noLights, leds: { ...leds }, rgb: [...rgb] });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    servos: servos.servos(),
    attachments: servos.attachments(),
    duty: motors.duty(),
    ultrasonic: sonar.state(),
    bumper: bumper.state(),
  });
  const step = (): void => {
    line.sample();
    servos.step();
  };
  return { wires: {}, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}

function modelOf(choice: string | undefined): Model {
  return choice === '1' || choice === '2' ? choice : '2E';
}

/**
 * Decides when the robot carries its bumper. The front has room for one thing: an attachment replaces the bumper,
 * unless the option asks for the bumper.
 */
function fittingOf({ options }: RobotContext, model: Model): 'never' | 'when-read' | 'always' {
  if (model === '1') return 'never';
  if (options['bumper'] === 'always') return 'always';
  return SERVO_PORTS.some((port) => (options[port] ?? 'none') !== 'none') ? 'never' : 'when-read';
}

function plugIn({ board }: RobotContext, { motors, lights, registers }: Controller) {
  const stops = [board.i2c.attach(MOTORS_ADDRESS, motors), board.i2c.attach(LIGHTS_ADDRESS, lights)];
  if (registers === null) return stops;
  const silent = SILENT_ADDRESSES.map((address) => board.i2c.attach(address, createRegisterMachine([])));
  return [...stops, board.i2c.attach(REGISTERS_ADDRESS, registers), ...silent];
}

/** Whole millimetres. No source says what the robot gives with nothing in range; an option chooses: far end or 0. */
function measured(distanceMm: number, isZeroWithoutEcho: boolean): number {
  if (distanceMm === Infinity) return isZeroWithoutEcho ? 0 : FARTHEST_MM;
  return Math.round(Math.max(distanceMm, NEAREST_MM));
}
