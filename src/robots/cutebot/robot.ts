/**
 * Elecfreaks Smart Cutebot: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * BS = microsoft/microbit-robot `botsim`, EF = Elecfreaks' own drivers.
 *
 *      P0  buzzer              P13  line sensor left      I2C 0x10  motors, headlamps, servos S1 S2: controller.ts
 *      P8  ultrasonic trigger  P14  line sensor right
 *      P12 ultrasonic echo     P15  two RGB LEDs
 *                              P16  infrared receiver
 */
import type { Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import type { Side } from '#devices/dc-motor';
import { attachHcSr04 } from '#devices/hc-sr04';
import { attachIrReceiver } from '#devices/ir-receiver';
import { attachLineSensor } from '#devices/line-sensor';
import { attachWs2812 } from '#devices/ws2812';
import { echoOf } from '../echo';
import { mountLinePair } from '../line-row';
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
import { CONTROLLER_ADDRESS, createController } from './controller';
import library from './library/cutebot.py?raw';
import { cutebot as type, SERVO_PORTS } from './type';

const LINE_AT = { left: { x: 42, y: 5.8 }, right: { x: 42, y: -5.8 } } as const; // BS
const LINE_PIN = { left: 'P13', right: 'P14' } as const;
const LINE_SPOT_RADIUS_MM = 2.5; // chosen, as for the Lite: a reflective sensor sees a spot as wide as its housing

const SONAR_AT: Vec = { x: 57, y: 0 }; // BS

const UNDERGLOW_COUNT = 2; // EF: left, right

/** Colour lights in the order of the state: headlamp left, right, then the LEDs below. */
const HEADLAMP: Readonly<Record<Side, 0 | 1>> = { left: 0, right: 1 };
const UNDERGLOW_FROM = 2;
const OFF: Rgb = [0, 0, 0];

const WIRES: Robot['wires'] = { P8: [], P12: [], P13: [], P14: [], P15: [], P16: [] };

export const cutebotBuild: RobotBuild = {
  type,
  // Elecfreaks' file is called Cutebot.py, Vittascience's cutebot.py: one source answers to both.
  libraries: { 'cutebot.py': library, 'Cutebot.py': library },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock } = context;
  const servos = mountServos(context, type, SERVO_PORTS);
  const motors = mountMotors(context);
  const tell = tellColors(context);
  const headlamps: [Rgb, Rgb] = [OFF, OFF];
  const controller = createController({
    motor: (side, duty) => {
      const { left, right } = motors.duty();
      motors.set(side === 'left' ? duty : left, side === 'right' ? duty : right, [side]);
    },
    headlamp: (side, color) => {
      headlamps[HEADLAMP[side]] = color;
      tell(HEADLAMP[side], color);
    },
    servo: (port, angleDeg) => servos.set(port, angleDeg),
  });
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const line = mountLinePair(context, LINE_AT, LINE_SPOT_RADIUS_MM, (view, side) =>
    attachLineSensor(board.wire(LINE_PIN[side]), view),
  );
  const underglow = attachWs2812(board.wire('P15'), UNDERGLOW_COUNT, (led, color) => tell(UNDERGLOW_FROM + led, color));
  const stops = [
    board.i2c.attach(CONTROLLER_ADDRESS, controller),
    attachHcSr04(
      clock,
      { trigger: board.wire('P8'), echo: board.wire('P12') },
      sonar.distanceMm,
      echoOf(context.options),
    ),
    attachIrReceiver(board.wire('P16'), context.infrared),
    line.stop,
    underglow.stop,
    servos.stop,
    motors.stop,
  ];

  const lights = (): RobotLights => ({ ...noLights, rgb: [...headlamps, ...underglow.colors()] });
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
