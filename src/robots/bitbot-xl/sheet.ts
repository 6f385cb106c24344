/** bit:bot XL: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import arms from './examples/arms.py?languages';
import distance from './examples/distance.py?languages';
import firstDrive from './examples/first_drive.py?languages';
import line from './examples/line.py?languages';
import night from './examples/night.py?languages';

export const bitbotXlSheet: RobotSheet = {
  robot: 'bitbot-xl',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...distance, course: 'empty' },
    arms,
    night,
  ],
  wiring: [
    { ...words.wiring.leftMotor, at: 'P16, P8' },
    { ...words.wiring.rightMotor, at: 'P14, P12' },
    { ...words.wiring.lineSensors, at: 'I2C 0x1C' },
    { ...words.wiring.ultrasonic, at: 'P15' },
    { ...words.wiring.leftLight, at: 'P2' },
    { ...words.wiring.rightLight, at: 'P1' },
    { ...words.wiring.colourLights, at: 'P13' },
    { ...words.wiring.buzzer, at: 'P0' },
    { ...words.wiring.memory, at: 'I2C 0x50' },
  ],
  registers: [
    {
      address: 0x1c,
      title: words.registers.expander.title,
      rows: [
        { register: '0x00', access: 'R', meaning: words.registers.expander.inputs },
        { register: '0x01', access: 'RW', meaning: words.registers.expander.outputs },
        { register: '0x02', access: 'RW', meaning: words.registers.expander.polarity },
        { register: '0x03', access: 'RW', meaning: words.registers.expander.configuration },
      ],
    },
    {
      address: 0x50,
      title: words.registers.memory.title,
      rows: [
        { register: '0x0000 … 0x0002', access: 'RW', meaning: words.registers.memory.bias },
        { register: '0x0003 … 0x0FFF', access: 'RW', meaning: words.registers.memory.free },
      ],
    },
  ],
};
