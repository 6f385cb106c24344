/**
 * New Robot: its wiring. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md.
 *
 *      P8   red LED           I2C 0x10  motors
 *      P13  line sensor
 */
import type { Vec } from '#core/geometry';
import { motorsTouched, signedDuty } from '#devices/dc-motor';
import { ledOn } from '#devices/led';
import { attachLineSensor } from '#devices/line-sensor';
import { mountMotors } from '../mounting';
import {
  bareState,
  noLights,
  type Robot,
  type RobotBuild,
  type RobotContext,
  type RobotLights,
  type RobotState,
} from '../robot';
import { CONTROLLER_ADDRESS, createController } from './controller';
import library from './library/new_robot.py?raw';
import { newRobot as type } from './type';

const LINE_AT: Vec = { x: 40, y: 0 }; // chosen
const LINE_SPOT_RADIUS_MM = 2.5; // chosen: the usual sensor sees a spot as wide as its housing, 5 mm

export const newRobotBuild: RobotBuild = {
  type,
  libraries: { 'new_robot.py': library },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, ground, scale } = context;
  const motors = mountMotors(context);
  const controller = createController(([dirL, speedL, dirR, speedR], touched) =>
    motors.set(signedDuty(dirL, speedL), signedDuty(dirR, speedR), motorsTouched(touched)),
  );
  const led = ledOn(board.wire('P8'));
  const line = attachLineSensor(board.wire('P13'), {
    look: (ago) => ground({ x: LINE_AT.x * scale, y: LINE_AT.y * scale }, LINE_SPOT_RADIUS_MM * scale, ago),
  });
  const stops = [board.i2c.attach(CONTROLLER_ADDRESS, controller), line.stop, motors.stop];

  const lights = (): RobotLights => ({ ...noLights, leds: { left: led.isLit(), right: 0 } });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: [{ name: 'middle', atMm: LINE_AT, bright: line.isBright() }],
    duty: motors.duty(),
  });
  const wires = { P8: ['light-left'], P13: [] } as const; // its only light counts as the left one
  return { wires, lights, state, step: () => line.sample(), detach: () => stops.forEach((stop) => stop()) };
}
