/** Maqueen Lite: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import firstDrive from './examples/first_drive.py?languages';
import lights from './examples/lights.py?languages';
import ring from './examples/ring.py?languages';
import servo from './examples/servo.py?languages';
import square from './examples/square.py?languages';

export const maqueenLiteSheet: RobotSheet = {
  robot: 'maqueen-lite',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...square, course: 'empty' },
    lights,
    { ...ring, course: 'empty' },
    { ...servo, course: 'empty', options: { S1: 'claw' } },
  ],
  wiring: [
    { ...words.wiring.motorsServos, at: 'I2C 0x10' },
    { ...words.wiring.leftRedLight, at: 'P8' },
    { ...words.wiring.rightRedLight, at: 'P12' },
    { ...words.wiring.leftLineSensor, at: 'P13' },
    { ...words.wiring.rightLineSensor, at: 'P14' },
    { part: words.wiring.ultrasonicTrigger, at: 'P1' },
    { ...words.wiring.ultrasonicEcho, at: 'P2' },
    { ...words.wiring.fourColourLights, at: 'P15' },
    { part: words.wiring.buzzer, at: 'P0' },
    { ...words.wiring.infraredReceiver, at: 'P16' },
  ],
  registers: [
    {
      address: 0x10,
      title: words.registers.robotsController.title,
      rows: [
        { register: '0x00', access: 'RW', meaning: words.registers.robotsController.leftMotorForward },
        { register: '0x01', access: 'RW', meaning: words.registers.robotsController.leftMotorPower },
        { register: '0x02', access: 'RW', meaning: words.registers.robotsController.rightMotorForward },
        { register: '0x03', access: 'RW', meaning: words.registers.robotsController.rightMotorPower },
        { register: '0x0B, 0x0C', access: 'RW', meaning: words.registers.robotsController.v5ColourLeft },
        { register: '0x0D … 0x12', access: 'RW', meaning: words.registers.robotsController.v5HowOften },
        { register: '0x14', access: 'RW', meaning: words.registers.robotsController.servoS1Degrees },
        { register: '0x15', access: 'RW', meaning: words.registers.robotsController.servoS2Degrees },
        { register: '0x1D', access: 'R', meaning: words.registers.robotsController.v5LineSensors },
        { register: '0x20 … 0x25', access: 'R', meaning: words.registers.robotsController.v5BrightnessGround },
        { register: '0x29 … 0x2C', access: 'R', meaning: words.registers.robotsController.v5LightFrom },
        { register: '0x2D, 0x2E', access: 'RW', meaning: words.registers.robotsController.v5KindBattery },
        { register: '0x32', access: 'R', meaning: words.registers.robotsController.lengthVersionText },
        { register: '0x33 …', access: 'R', meaning: words.registers.robotsController.versionText },
        { register: '0x46', access: 'W', meaning: words.registers.robotsController.v5StartAnew },
        { register: '0x47, 0x48', access: 'RW', meaning: words.registers.robotsController.v5FollowsLine },
      ],
    },
  ],
};
