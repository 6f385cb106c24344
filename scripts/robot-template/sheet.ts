/** New Robot: what the gallery tells about it. */
import type { RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';

export const newRobotSheet: RobotSheet = {
  robot: 'new-robot',
  about: {
    de: 'Ein Roboter mit zwei Rädern, einem Liniensensor und einem roten Licht.',
    en: 'A robot with two wheels, one line sensor and a red light.',
  },
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', en: 'First drive' },
      source: { de: firstDriveDe, en: firstDriveEn },
    },
  ],
  wiring: [
    { part: { de: 'Motoren', en: 'Motors' }, at: 'I2C 0x10' },
    { part: { de: 'Rotes Licht', en: 'Red light' }, at: 'P8', note: { de: '1 = ein', en: '1 = on' } },
    {
      part: { de: 'Liniensensor', en: 'Line sensor' },
      at: 'P13',
      note: { de: '1 = hell, 0 = dunkel', en: '1 = light, 0 = dark' },
    },
  ],
  registers: [
    {
      address: 0x10,
      title: { de: 'Motoren', en: 'Motors' },
      rows: [
        {
          register: '0x00, 0x02',
          access: 'RW',
          meaning: {
            de: 'Richtung links, rechts: 0 vorwärts, 1 rückwärts',
            en: 'Direction left, right: 0 forward, 1 backward',
          },
        },
        {
          register: '0x01, 0x03',
          access: 'RW',
          meaning: { de: 'Tempo links, rechts: 0 bis 255', en: 'Speed left, right: 0 to 255' },
        },
      ],
    },
  ],
};
