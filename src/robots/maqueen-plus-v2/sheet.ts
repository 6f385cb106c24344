/** Maqueen Plus V2: what the gallery tells about it. */
import { wordsOf } from '#core/words';
import type { RobotSheet } from '../robot';
import distanceDe from './examples/distance.de.py?raw';
import distanceFr from './examples/distance.fr.py?raw';
import distanceIt from './examples/distance.it.py?raw';
import distanceEn from './examples/distance.en.py?raw';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveFr from './examples/first_drive.fr.py?raw';
import firstDriveIt from './examples/first_drive.it.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsFr from './examples/lights.fr.py?raw';
import lightsIt from './examples/lights.it.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineFr from './examples/line.fr.py?raw';
import lineIt from './examples/line.it.py?raw';
import lineEn from './examples/line.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoFr from './examples/servo.fr.py?raw';
import servoIt from './examples/servo.it.py?raw';
import servoEn from './examples/servo.en.py?raw';
import type de from './words/sheet/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/sheet/*.json', { eager: true, import: 'default' }));

export const maqueenPlusV2Sheet: RobotSheet = {
  robot: 'maqueen-plus-v2',
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
      file: 'distance.py',
      title: { de: 'Nicht anstossen', fr: 'Ne pas heurter', it: 'Non urtare', en: 'Do not bump' },
      source: { de: distanceDe, fr: distanceFr, it: distanceIt, en: distanceEn },
      course: 'empty',
    },
    {
      file: 'lights.py',
      title: {
        de: 'Lichter und Helligkeit',
        fr: 'Lumières et clarté',
        it: 'Luci e luminosità',
        en: 'Lights and brightness',
      },
      source: { de: lightsDe, fr: lightsFr, it: lightsIt, en: lightsEn },
      course: 'closed-line',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', fr: 'Un servo', it: 'Un servo', en: 'A servo' },
      source: { de: servoDe, fr: servoFr, it: servoIt, en: servoEn },
      course: 'empty',
      options: { P1: 'claw' },
    },
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
