/** New Robot: what the gallery tells about it. */
import type { RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveFr from './examples/first_drive.fr.py?raw';
import firstDriveIt from './examples/first_drive.it.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';

export const newRobotSheet: RobotSheet = {
  robot: 'new-robot',
  about: {
    de: 'Ein Roboter mit zwei Rädern, einem Liniensensor und einem roten Licht.',
    fr: 'Un robot avec deux roues, un capteur de ligne et une lumière rouge.',
    it: 'Un robot con due ruote, un sensore di linea e una luce rossa.',
    en: 'A robot with two wheels, one line sensor and a red light.',
  },
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', fr: 'Premier trajet', it: 'Primo viaggio', en: 'First drive' },
      source: { de: firstDriveDe, fr: firstDriveFr, it: firstDriveIt, en: firstDriveEn },
    },
  ],
  wiring: [
    { part: { de: 'Motoren', fr: 'Moteurs', it: 'Motori', en: 'Motors' }, at: 'I2C 0x10' },
    {
      part: { de: 'Rotes Licht', fr: 'Lumière rouge', it: 'Luce rossa', en: 'Red light' },
      at: 'P8',
      note: { de: '1 = ein', fr: '1 = allumée', it: '1 = accesa', en: '1 = on' },
    },
    {
      part: { de: 'Liniensensor', fr: 'Capteur de ligne', it: 'Sensore di linea', en: 'Line sensor' },
      at: 'P13',
      note: {
        de: '1 = hell, 0 = dunkel',
        fr: '1 = clair, 0 = sombre',
        it: '1 = chiaro, 0 = scuro',
        en: '1 = light, 0 = dark',
      },
    },
  ],
  registers: [
    {
      address: 0x10,
      title: { de: 'Motoren', fr: 'Moteurs', it: 'Motori', en: 'Motors' },
      rows: [
        {
          register: '0x00, 0x02',
          access: 'RW',
          meaning: {
            de: 'Richtung links, rechts: 0 vorwärts, 1 rückwärts',
            fr: 'Sens à gauche, à droite : 0 en avant, 1 en arrière',
            it: 'Direzione a sinistra, a destra: 0 avanti, 1 indietro',
            en: 'Direction left, right: 0 forward, 1 backward',
          },
        },
        {
          register: '0x01, 0x03',
          access: 'RW',
          meaning: {
            de: 'Tempo links, rechts: 0 bis 255',
            fr: 'Vitesse à gauche, à droite : 0 à 255',
            it: 'Velocità a sinistra, a destra: da 0 a 255',
            en: 'Speed left, right: 0 to 255',
          },
        },
      ],
    },
  ],
};
