/**
 * DFRobot Maqueen Plus V2: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * GBSL = GBSL-Informatik/maqueen-plus-v2-mpy, ETH = Tiger-Jython/Robotics-Libraries `mbrobot_plusV2.py`.
 *
 *      P0  buzzer, servo       P13  ultrasonic trigger     I2C 0x10  motors, red lights, line sensors, version
 *      P1  servo               P14  ultrasonic echo
 *      P2  servo               P15  four RGB LEDs
 *                              P16  infrared receiver
 */
import type { Vec } from '#core/geometry';
import { signedDuty } from '#devices/dc-motor';
import { attachIrReceiver } from '#devices/ir-receiver';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachWs2812 } from '#devices/ws2812';
import { echoOf } from '../echo';
import { listenToServos, mountMotors, mountServos, tellColors } from '../mounting';
import { mountLineRow } from '../line-row';
import { PLUS_LINE_SENSORS, PLUS_LINE_SPOT_RADIUS_MM } from '../maqueen-plus-frame';
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
import { CONTROLLER_ADDRESS, createController, type MotorBytes } from './controller';
import mbrobotPlusV2 from './library/mbrobot_plusV2.py?raw';
import { maqueenPlusV2 as type, SERVO_PORTS } from './type';

/** Readings of the sensors on black and on bare floor. Linear in between: chosen. */
const BRIGHTNESS = {
  'light-high': { black: 100, floor: 230 }, // measured by the author of a TigerJython teaching project
  'light-low': { black: 240, floor: 70 }, // jdonwells/micropython-MaqueenPlusV2: about 240 on a line, about 70 off it
} as const;

/** The cans end at the body's front edge: chosen from the drawing; the V2's figure is not published. */
const SONAR_AT: Vec = { x: 76, y: 0 };

const RGB_COUNT = 4; // front left, back left, back right, front right: ETH

const WIRES: Robot['wires'] = { P13: [], P14: [], P15: [], P16: [] };

export const maqueenPlusV2Build: RobotBuild = {
  type,
  libraries: { 'mbrobot_plusV2.py': mbrobotPlusV2 },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock, options, onSet } = context;
  const servos = mountServos(context, type, SERVO_PORTS);
  const motors = mountMotors(context);
  const leds: { left: 0 | 1; right: 0 | 1 } = { left: 0, right: 0 };
  const brightness = BRIGHTNESS[options['analogPolarity'] === 'light-low' ? 'light-low' : 'light-high'];
  const line = mountLineRow(context, PLUS_LINE_SENSORS, {
    spotRadiusMm: PLUS_LINE_SPOT_RADIUS_MM,
    ...brightness,
    most: 255,
  });
  const controller = createController(
    {
      motors: ({ left, right }, sides) => motors.set(dutyOf(left), dutyOf(right), sides),
      leds: (left, right, sides) => {
        Object.assign(leds, { left, right });
        for (const side of sides) onSet?.(`light-${side}`, leds[side]);
      },
      isBright: line.isBright,
      brightness: line.reading,
    },
    {
      version: options['version'] === '2.0' ? '2.0' : '2.1',
      analogOrder: options['analogOrder'] === 'L2-first' ? 'L2-first' : 'R2-first',
    },
  );
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const underglow = attachWs2812(board.wire('P15'), RGB_COUNT, tellColors(context));
  const stops = [
    board.i2c.attach(CONTROLLER_ADDRESS, controller),
    attachHcSr04(clock, { trigger: board.wire('P13'), echo: board.wire('P14') }, sonar.distanceMm, echoOf(options)),
    ...listenToServos(context, SERVO_PORTS, (port, angleDeg) => servos.set(port, angleDeg)),
    attachIrReceiver(board.wire('P16'), context.infrared),
    line.stop,
    underglow.stop,
    servos.stop,
    motors.stop,
  ];
  const lights = (): RobotLights => ({ ...noLights, leds: { ...leds }, rgb: underglow.colors() });
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
  return { wires: WIRES, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}

/**
 * The duty of a motor; 0 for a direction that the robot does not know. Two owners who used the driver of a Plus V1
 * (1 forward, 2 backward) report this in the maker's forum: forward drives back, backward does nothing.
 */
const dutyOf = ([direction, speed]: MotorBytes['left']): number => (direction > 1 ? 0 : signedDuty(direction, speed));
