/** Maqueen Plus V2: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import distance from './examples/distance.py?languages';
import firstDrive from './examples/first_drive.py?languages';
import lights from './examples/lights.py?languages';
import line from './examples/line.py?languages';
import servo from './examples/servo.py?languages';

export const maqueenPlusV2Sheet: RobotSheet = {
  robot: 'maqueen-plus-v2',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...distance, course: 'empty' },
    { ...lights, course: 'closed-line' },
    { ...servo, course: 'empty', options: { P1: 'claw' } },
  ],
  wiring: [
    { ...words.wiring.motorsRedLights, at: 'I2C 0x10' },
    { part: words.wiring.ultrasonicTrigger, at: 'P13' },
    { ...words.wiring.ultrasonicEcho, at: 'P14' },
    { ...words.wiring.fourColourLights, at: 'P15' },
    { ...words.wiring.servosP0P1, at: 'P0, P1, P2' },
    { ...words.wiring.buzzer, at: 'P0' },
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
        { register: '0x0B', access: 'RW', meaning: words.registers.robotsController.leftRedLight },
        { register: '0x0C', access: 'RW', meaning: words.registers.robotsController.rightRedLight },
        { register: '0x1D', access: 'R', meaning: words.registers.robotsController.lineSensorsBit },
        { register: '0x1E … 0x27', access: 'R', meaning: words.registers.robotsController.brightnessR2R1 },
        { register: '0x32', access: 'R', meaning: words.registers.robotsController.lengthVersionText },
        { register: '0x33 …', access: 'R', meaning: words.registers.robotsController.versionTextSuch },
      ],
    },
  ],
};
