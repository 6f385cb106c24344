/** Maqueen Plus V1: what the gallery tells about it. */
import { wordsOf } from '#core/words';
import type { RegisterTable, RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveFr from './examples/first_drive.fr.py?raw';
import firstDriveIt from './examples/first_drive.it.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineFr from './examples/line.fr.py?raw';
import lineIt from './examples/line.it.py?raw';
import lineEn from './examples/line.en.py?raw';
import wheelsDe from './examples/wheels.de.py?raw';
import wheelsFr from './examples/wheels.fr.py?raw';
import wheelsIt from './examples/wheels.it.py?raw';
import wheelsEn from './examples/wheels.en.py?raw';
import type de from './words/sheet/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/sheet/*.json', { eager: true, import: 'default' }));

const controller: RegisterTable = {
  address: 0x10,
  title: words.controller.title,
  rows: [
    { register: '0x00, 0x02', access: 'RW', meaning: words.controller.directionLeftRight },
    { register: '0x01, 0x03', access: 'RW', meaning: words.controller.powerLeftRight },
    { register: '0x04 … 0x07', access: 'RW', meaning: words.controller.pulsesWheelsLeft },
    { register: '0x0A', access: 'RW', meaning: words.controller.robotKeepsSpeed },
    { register: '0x0B, 0x0C', access: 'RW', meaning: words.controller.lightLeftRight },
    { register: '0x14 … 0x16', access: 'RW', meaning: words.controller.angleServosS1 },
    { register: '0x1D', access: 'R', meaning: words.controller.lineSensorsBit },
    { register: '0x1E … 0x29', access: 'R', meaning: words.controller.brightnessBelowL3 },
    { register: '0x32, 0x33 …', access: 'R', meaning: words.controller.lengthVersionText },
  ],
};

export const maqueenPlusV1Sheet: RobotSheet = {
  robot: 'maqueen-plus-v1',
  about: words.about,
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', fr: 'Premier trajet', it: 'Primo viaggio', en: 'First drive' },
      source: { de: firstDriveDe, fr: firstDriveFr, it: firstDriveIt, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'line.py',
      title: { de: 'Einer Linie folgen', fr: 'Suivre une ligne', it: 'Seguire una linea', en: 'Follow a line' },
      source: { de: lineDe, fr: lineFr, it: lineIt, en: lineEn },
      course: 'closed-line',
    },
    {
      file: 'wheels.py',
      title: {
        de: 'Genau einen halben Meter',
        fr: 'Exactement un demi-mètre',
        it: 'Esattamente mezzo metro',
        en: 'Exactly half a metre',
      },
      source: { de: wheelsDe, fr: wheelsFr, it: wheelsIt, en: wheelsEn },
      course: 'empty',
    },
  ],
  wiring: [
    { ...words.wiring.motorsLightsServos, at: 'I2C 0x10' },
    { part: words.wiring.ultrasonicTrigger, at: 'P1' },
    { ...words.wiring.ultrasonicEcho, at: 'P2' },
    { part: words.wiring.buzzer, at: 'P0' },
  ],
  registers: [controller],
};
