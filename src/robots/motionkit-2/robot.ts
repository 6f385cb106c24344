/**
 * Calliope MotionKit 2: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md. This is
 * the robot whose parts all answer by I2C; an older one of the same name had lights, line sensors and ultrasonic sensor
 * on pins.
 *
 *      I2C 0x10  motors, lights, colour lights, line sensors, ultrasonic sensor, infrared receiver, servos S1 S2, version
 *
 * See controller.ts for the bytes.
 */
import type { Clock } from '#core/clock';
import type { Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import { signedDuty, type Side } from '#devices/dc-motor';
import { NEAREST_MM } from '#devices/hc-sr04';
import { attachNecDecoder } from '#devices/nec-remote';
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
import { CONTROLLER_ADDRESS, createController, SIDES, type MotorBytes } from './controller';
import callimk from './library/callimk.py?raw';
import { motionkit2 as type, SERVO_PORTS } from './type';

/** Estimated: the Maqueen Lite's. */
const LINE_SENSORS: readonly LinePlace<Side>[] = [
  { name: 'left', atMm: { x: 34, y: 7 } },
  { name: 'right', atMm: { x: 34, y: -7 } },
];
const LINE_SPOT_RADIUS_MM = 2.5; // chosen, as for the Maqueens: as wide as the sensor's housing
/** Chosen: those measured on a Maqueen Plus V2, whose controller by the same maker gives the same range of 0 … 255. */
const BRIGHTNESS = { black: 100, floor: 230, most: 255 } as const;

const SONAR_AT: Vec = { x: 55, y: 0 }; // estimated: the Maqueen Lite's

const COLOR_LIGHTS = 4; // chosen: as many as the older MotionKit 2 had (tinysuperlab/MotionKitV2MicroPython)

const OUT_OF_RANGE = -1; // chbijou's list
const MM_PER_CM = 10;

export const motionkit2Build: RobotBuild = {
  type,
  libraries: { 'callimk.py': callimk },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock, options, onSet } = context;
  const tell = tellColors(context);
  const servos = mountServos(context, type, SERVO_PORTS);
  const motors = mountMotors(context);
  const line = mountLineRow(context, LINE_SENSORS, { spotRadiusMm: LINE_SPOT_RADIUS_MM, ...BRIGHTNESS });
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const infrared = attachNecDecoder(clock, context.infrared);
  const leds: { left: 0 | 1; right: 0 | 1 } = { left: 0, right: 0 };
  let shown: Rgb = [0, 0, 0];

  const controller = createController(
    {
      motors: ({ left, right }, sides) => motors.set(dutyOf(left), dutyOf(right), sides),
      light: (side, isLit) => {
        leds[side] = isLit ? 1 : 0;
        onSet?.(`light-${side}`, leds[side]);
      },
      servo: (port, angleDeg) => servos.set(port, angleDeg),
      color: (color) => {
        shown = color;
        for (let light = 0; light < COLOR_LIGHTS; light++) tell(light, color);
      },
      isBright: line.isBright,
      brightness: line.reading,
      distanceCm: oncePerMoment(clock, () => distanceCm(sonar.distanceMm(), options['echo'] === 'zero')),
      infraredCode: infrared.code,
    },
    sidesOf(options['sides']),
  );
  const stops = [board.i2c.attach(CONTROLLER_ADDRESS, controller), infrared.stop, line.stop, servos.stop, motors.stop];

  const lights = (): RobotLights => ({
    ...noLights,
    leds: { ...leds },
    rgb: Array.from({ length: COLOR_LIGHTS }, () => shown),
  });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    servos: servos.servos(),
    attachments: servos.attachments(),
    duty: motors.duty(),
    ultrasonic: sonar.state(),
  });
  const step = (): void => {
    line.sample();
    servos.step();
  };
  return { wires: {}, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}

const sidesOf = (choice: string | undefined) =>
  choice === 'lights-swapped' || choice === 'all-swapped' ? SIDES[choice] : SIDES.maker;

const dutyOf = ({ direction, speed }: MotorBytes): number => signedDuty(direction, speed);

/** Whole centimetres; with nothing in range −1, or 0 by option. */
function distanceCm(distanceMm: number, isZeroWithoutEcho: boolean): number {
  if (distanceMm === Infinity) return isZeroWithoutEcho ? 0 : OUT_OF_RANGE;
  return Math.round(Math.max(distanceMm, NEAREST_MM) / MM_PER_CM);
}

/** Measures once for all bytes of a transfer, within which no time passes: they belong to one measurement. */
function oncePerMoment(clock: Clock, measure: () => number): () => number {
  let atUs = -1;
  let value = 0;
  return () => {
    if (atUs !== clock.nowUs) value = measure();
    atUs = clock.nowUs;
    return value;
  };
}
