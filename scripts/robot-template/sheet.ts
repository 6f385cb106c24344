/** New Robot: what the gallery tells about it. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import firstDrive from './examples/first_drive.py?languages';

export const newRobotSheet: RobotSheet = {
  robot: 'new-robot',
  about: words.about,
  examples: [firstDrive],
  wiring: [
    { part: words.wiring.motors, at: 'I2C 0x10' },
    { ...words.wiring.redLight, at: 'P8' },
    { ...words.wiring.lineSensor, at: 'P13' },
  ],
  registers: [
    {
      address: 0x10,
      title: words.registers.motors.title,
      rows: [
        { register: '0x00, 0x02', access: 'RW', meaning: words.registers.motors.directionLeftRight },
        { register: '0x01, 0x03', access: 'RW', meaning: words.registers.motors.speedLeftRight },
      ],
    },
  ],
};
