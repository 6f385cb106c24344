/** MotionKit 2: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import distance from './examples/distance.py?languages';
import firstDrive from './examples/first_drive.py?languages';
import lights from './examples/lights.py?languages';
import line from './examples/line.py?languages';
import servo from './examples/servo.py?languages';

const AT = 'I2C 0x10';
const { controller } = words.registers;

export const motionkit2Sheet: RobotSheet = {
  robot: 'motionkit-2',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...distance, course: 'empty' },
    lights,
    { ...servo, course: 'empty', options: { S1: 'claw' } },
  ],
  wiring: [
    { ...words.wiring.motors, at: AT },
    { ...words.wiring.redLights, at: AT },
    { ...words.wiring.colourLights, at: AT },
    { ...words.wiring.lineSensors, at: AT },
    { ...words.wiring.ultrasonic, at: AT },
    { ...words.wiring.servos, at: AT },
    { ...words.wiring.infrared, at: AT },
  ],
  registers: [
    {
      address: 0x10,
      title: controller.title,
      rows: [
        { register: '0x00, 0x01', access: 'RW', meaning: controller.leftMotor },
        { register: '0x02, 0x03', access: 'RW', meaning: controller.rightMotor },
        { register: '0x0B, 0x0C', access: 'RW', meaning: controller.lights },
        { register: '0x14, 0x15', access: 'RW', meaning: controller.servos },
        { register: '0x18 … 0x1A', access: 'RW', meaning: controller.colour },
        { register: '0x1D', access: 'R', meaning: controller.lineBits },
        { register: '0x1E, 0x20', access: 'R', meaning: controller.lineValues },
        { register: '0x28, 0x29', access: 'R', meaning: controller.distance },
        { register: '0x2B … 0x2E', access: 'R', meaning: controller.infrared },
        { register: '0x32', access: 'R', meaning: controller.versionLength },
        { register: '0x33 …', access: 'R', meaning: controller.version },
      ],
    },
  ],
};
