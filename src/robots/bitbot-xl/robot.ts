/**
 * 4tronix bit:bot XL (v1.2): its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * 4T = 4tronix/BitBot `bitbot.ts`, GMC = gmc-code/PC-Microbit-Extension.
 *
 *      P0  buzzer          P8   left motor backward      P14  right motor forward
 *      P1  light right     P12  right motor backward     P15  ultrasonic, trigger and echo
 *      P2  light left      P13  twelve RGB LEDs          P16  left motor forward
 *
 *      I2C 0x1C  line sensors and version      I2C 0x50  EEPROM
 */
import type { Wire } from '#board/wires/wire';
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import { createEeprom } from '#devices/eeprom';
import { attachHBridge, type HBridgeInputs } from '#devices/h-bridge';
import { BOTH_SIDES, type Side } from '#devices/dc-motor';
import { bitsOf } from '#devices/i2c-registers';
import { attachHcSr04 } from '#devices/hc-sr04';
import { createLineComparator } from '#devices/line-sensor';
import { createPca9557 } from '#devices/pca9557';
import { attachWs2812 } from '#devices/ws2812';
import { echoOf } from '../echo';
import { lightEyes, type LightEye } from '../light-eyes';
import { mountLinePair } from '../line-row';
import { mountMotors, tellColors } from '../mounting';
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
import mbbitbot from './library/mbbitbot.py?raw';
import { bitbotXl as type } from './type';

/** The port expander with the line sensors: 4T; that it is a PCA9557: GMC. */
export const LINE_ADDRESS = 0x1c;
/** 4T, of the v1.2 alone. */
export const EEPROM_ADDRESS = 0x50;

/** Bits 4 … 7 of the expander's byte: 5 = v1.2 (4T). Those pins are read turned round, so their levels are 10. */
const VERSION_LEVELS = (~5 & 0x0f) << 4;

/** Estimated: under the front edge, as far apart as on the Maqueens, so that both fit on a line of 20 mm. */
const LINE_AT = { left: { x: 52, y: 8 }, right: { x: 52, y: -8 } } as const;
const LINE_SPOT_RADIUS_MM = 2.5; // chosen: the usual reflective sensor sees a spot as wide as its housing, 5 mm

/** The sensor is plugged in at the front: chosen, its cans end near the front edge. */
const SONAR_AT: Vec = { x: 70, y: 0 };

const RGB_COUNT = 12; // 4T; 0 … 5 left arm, 6 … 11 right arm: GMC, BitBotXL_LEDs

const LIGHT_FULL = 255; // the highest light level

/** On the two arms: chosen. */
const LIGHT_EYES = lightEyes({ x: 55, y: 38 });

const WIRES: Robot['wires'] = { P1: [], P2: [], P8: [], P12: [], P13: [], P14: [], P15: [], P16: [] };

export const bitbotXlBuild: RobotBuild = {
  type,
  libraries: { 'mbbitbot.py': mbbitbot },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock } = context;
  const line = mountLinePair(context, LINE_AT, LINE_SPOT_RADIUS_MM, createLineComparator);
  // 1 on black: 4T.
  const levels = (): number => bitsOf(BOTH_SIDES, (side) => !line.sensors[side].isBright()) | VERSION_LEVELS;
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => 0 });
  const drive = mountDrive(context);
  const arms = attachWs2812(board.wire('P13'), RGB_COUNT, tellColors(context));
  const lightSensors = [
    attachLightSensor(context, board.wire('P2'), LIGHT_EYES.left),
    attachLightSensor(context, board.wire('P1'), LIGHT_EYES.right),
  ];
  const sonarWire = board.wire('P15');
  const stops = [
    board.i2c.attach(LINE_ADDRESS, createPca9557(levels)),
    board.i2c.attach(EEPROM_ADDRESS, createEeprom()),
    attachHcSr04(clock, { trigger: sonarWire, echo: sonarWire }, sonar.distanceMm, echoOf(context.options)),
    line.stop,
    arms.stop,
    ...lightSensors.map(({ stop }) => stop),
    drive.stop,
  ];

  const lights = (): RobotLights => ({ ...noLights, rgb: arms.colors() });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    duty: drive.duty(),
    ultrasonic: sonar.state(),
  });
  const step = (): void => {
    line.sample();
    for (const sensor of lightSensors) sensor.sample();
  };
  return { wires: WIRES, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}

/** The two motors, each between two pins. */
function mountDrive(context: RobotContext) {
  const { board } = context;
  const motors = mountMotors(context);
  const duty = { left: 0, right: 0 };
  const mount = (side: Side, inputs: HBridgeInputs): Stop =>
    attachHBridge(inputs, (value) => {
      duty[side] = value;
      motors.set(duty.left, duty.right, [side]);
    });
  const stops = [
    mount('left', { forward: board.wire('P16'), backward: board.wire('P8') }),
    mount('right', { forward: board.wire('P14'), backward: board.wire('P12') }),
    motors.stop,
  ];
  return { duty: motors.duty, stop: (): void => stops.forEach((stop) => stop()) };
}

/** A light sensor on a wire: the more light it sees, the higher its voltage, up to the supply's. */
function attachLightSensor({ lightLevel }: RobotContext, wire: Wire, eye: LightEye) {
  const output = wire.connect('light sensor');
  let level = -1;
  const sample = (): void => {
    const now = lightLevel(eye);
    if (now === level) return;
    level = now;
    output.driveAnalog(level / LIGHT_FULL);
  };
  sample();
  return { sample, stop: output.detach };
}
