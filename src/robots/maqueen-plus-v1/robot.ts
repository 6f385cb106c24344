/**
 * DFRobot Maqueen Plus V1: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * NOE = NoeSchaller/TS_Maqueen, DF = DFRobot/pxt-DFRobot-Maqueenplus.
 *
 *      P0  buzzer                I2C 0x10  motors, pulses, speed control, colour lights, servos S1 S2 S3,
 *      P1  ultrasonic trigger              line sensors, version
 *      P2  ultrasonic echo       P16       infrared receiver
 */
import type { Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachIrReceiver } from '#devices/ir-receiver';
import { mountLineRow, type LinePlace } from '../line-row';
import { mountServos, tellColors } from '../mounting';
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
import { CONTROLLER_ADDRESS, createController, type LineName } from './controller';
import { createDrive } from './drive';
import mbrobotPlus from './library/mbrobot_plus.py?raw';
import { maqueenPlusV1 as type, SERVO_PORTS } from './type';

/** Four in a row in front, one at each side: NOE. */
const LINE_SENSORS: readonly LinePlace<LineName>[] = [
  { name: 'L3', atMm: { x: 38, y: 45 } },
  { name: 'L2', atMm: { x: 58, y: 15 } },
  { name: 'L1', atMm: { x: 58, y: 5 } },
  { name: 'R1', atMm: { x: 58, y: -5 } },
  { name: 'R2', atMm: { x: 58, y: -15 } },
  { name: 'R3', atMm: { x: 38, y: -45 } },
];
const LINE_SPOT_RADIUS_MM = 2.5; // chosen, as for the Lite: a reflective sensor sees a spot as wide as its housing

/**
 * Readings of the sensors, up to 4095. Chosen between the thresholds of published MakeCode programs for the robot,
 * which take less than 1300 for dark, 2800 for the edge of a line and more than 3200 for light. Linear in between:
 * chosen.
 */
const BRIGHTNESS = { black: 1000, floor: 3500, most: 4095 };

/** In front of the micro:bit, near the front edge: chosen. NOE puts it 48 mm ahead of the axle. */
const SONAR_AT: Vec = { x: 74, y: 0 };

const WIRES: Robot['wires'] = { P1: [], P2: [], P16: [] };

export const maqueenPlusV1Build: RobotBuild = {
  type,
  libraries: { 'mbrobot_plus.py': mbrobotPlus },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock, onSet } = context;
  const tell = tellColors(context);
  const servos = mountServos(context, type, SERVO_PORTS);
  const drive = createDrive(context);
  const line = mountLineRow(context, LINE_SENSORS, { spotRadiusMm: LINE_SPOT_RADIUS_MM, ...BRIGHTNESS });
  let lamps: readonly [Rgb, Rgb] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  const controller = createController({
    ...drive,
    motors: (left, right, sides) => {
      drive.motors(left, right);
      for (const side of sides) onSet?.(`wheel-${side}`, side === 'left' ? left : right);
    },
    isBright: line.isBright,
    brightness: line.reading,
    lights: (left, right, { first, last }) => {
      lamps = [left, right];
      for (let led = first; led <= last; led++) tell(led, lamps[led === 0 ? 0 : 1]);
    },
    servo: (index, angleDeg) => servos.set(SERVO_PORTS[index] ?? '', angleDeg),
  });
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const stops = [
    board.i2c.attach(CONTROLLER_ADDRESS, controller),
    attachHcSr04(clock, { trigger: board.wire('P1'), echo: board.wire('P2') }, () => sonar.distanceMm()),
    attachIrReceiver(board.wire('P16'), context.infrared),
    line.stop,
    servos.stop,
    drive.stop,
  ];
  const lights = (): RobotLights => ({ ...noLights, rgb: lamps });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    servos: servos.servos(),
    attachments: servos.attachments(),
    duty: drive.duty(),
    ultrasonic: sonar.state(),
  });
  const step = (): void => {
    drive.step();
    line.sample();
    servos.step();
  };
  return { wires: WIRES, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}
