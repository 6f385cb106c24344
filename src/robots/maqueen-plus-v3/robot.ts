/**
 * DFRobot Maqueen Plus V3: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md.
 *
 *      P0  buzzer, servo S1             P13  ultrasonic trigger, if plugged in     I2C 0x10  motors, lamps, line sensors
 *      P1  servo S2, four RGB LEDs      P14  ultrasonic echo                       I2C 0x33  lidar
 *      P2  servo S3                     P16  infrared receiver
 */
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import { attachIrReceiver } from '#devices/ir-receiver';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachWs2812 } from '#devices/ws2812';
import { echoOf } from '../echo';
import { mountLidar } from '../lidar';
import { mountLineRow } from '../line-row';
import { PLUS_LINE_SENSORS, PLUS_LINE_SPOT_RADIUS_MM } from '../maqueen-plus-frame';
import { listenToServos, mountServos, tellColors } from '../mounting';
import {
  bareState,
  noLights,
  type Robot,
  type RobotBuild,
  type RobotContext,
  type RobotLights,
  type RobotState,
} from '../robot';
import { mountSonar, SR04_CONE, type Sonar } from '../sonar';
import { mountChassis } from './chassis';
import mbrobotPlusV3 from './library/mbrobot_plusV3.py?raw';
import { maqueenPlusV3 as type, SERVO_PORTS } from './type';

/** Readings on black and on the bare floor: franc0r/francor-maqueen-plus-microbit, of 4095. Linear in between: chosen. */
const BRIGHTNESS = { black: 2700, floor: 3800, most: 4095 };

/** Upright on its bracket at the front edge: chosen from the drawing; a bracket can be screwed on elsewhere. */
const LIDAR_AT: Vec = { x: 77, y: 0 };

/** Its socket is that of the V2: its cans end at the front edge. */
const SONAR_AT: Vec = { x: 76, y: 0 };

const RGB_COUNT = 4; // front left, back left, back right, front right: sjh5637/myMaqueenPlusV3_extension

export const maqueenPlusV3Build: RobotBuild = {
  type,
  libraries: { 'mbrobot_plusV3.py': mbrobotPlusV3 },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, options } = context;
  const servos = mountServos(context, type, SERVO_PORTS);
  const line = mountLineRow(context, PLUS_LINE_SENSORS, { spotRadiusMm: PLUS_LINE_SPOT_RADIUS_MM, ...BRIGHTNESS });
  const chassis = mountChassis(context, line);
  const sonar = options['ultrasonic'] === 'yes' ? plugInSonar(context, () => servos.sonarTurnRad()) : null;
  const lidar = options['lidar'] === 'none' ? null : mountLidar(context, LIDAR_AT);
  const underglow = attachWs2812(board.wire('P1'), RGB_COUNT, tellColors(context));
  const stops: readonly Stop[] = [
    ...listenToServos(context, SERVO_PORTS, (port, angleDeg) => servos.set(port, angleDeg)),
    attachIrReceiver(board.wire('P16'), context.infrared),
    line.stop,
    ...(sonar === null ? [] : [sonar.stop]),
    ...(lidar === null ? [] : [lidar.stop]),
    underglow.stop,
    servos.stop,
    chassis.stop,
  ];
  const lights = (): RobotLights => ({ ...noLights, rgb: underglow.colors(), lamps: chassis.lamps() });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    servos: servos.servos(),
    attachments: servos.attachments(),
    duty: chassis.duty(),
    ultrasonic: sonar?.state() ?? null,
    lidar: lidar?.state() ?? null,
  });
  const step = (): void => {
    line.sample();
    chassis.step();
    servos.step();
  };
  const wires: Robot['wires'] = { P1: [], P16: [], ...(sonar && { P13: [], P14: [] }) };
  return { wires, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}

function plugInSonar(context: RobotContext, turnRad: () => number): Pick<Sonar, 'state'> & { readonly stop: Stop } {
  const { board, clock, options } = context;
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad });
  const wires = { trigger: board.wire('P13'), echo: board.wire('P14') };
  return { state: () => sonar.state(), stop: attachHcSr04(clock, wires, sonar.distanceMm, echoOf(options)) };
}
