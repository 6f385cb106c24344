/** Maqueen Lite: what the gallery tells about it. */
import { wordsOf } from '#core/words';
import type { RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveFr from './examples/first_drive.fr.py?raw';
import firstDriveIt from './examples/first_drive.it.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsFr from './examples/lights.fr.py?raw';
import lightsIt from './examples/lights.it.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import ringDe from './examples/ring.de.py?raw';
import ringFr from './examples/ring.fr.py?raw';
import ringIt from './examples/ring.it.py?raw';
import ringEn from './examples/ring.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoFr from './examples/servo.fr.py?raw';
import servoIt from './examples/servo.it.py?raw';
import servoEn from './examples/servo.en.py?raw';
import squareDe from './examples/square.de.py?raw';
import squareFr from './examples/square.fr.py?raw';
import squareIt from './examples/square.it.py?raw';
import squareEn from './examples/square.en.py?raw';
import type de from './words/sheet/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/sheet/*.json', { eager: true, import: 'default' }));

export const maqueenLiteSheet: RobotSheet = {
  robot: 'maqueen-lite',
  about: words.about,
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', fr: 'Premier trajet', it: 'Primo viaggio', en: 'First drive' },
      source: { de: firstDriveDe, fr: firstDriveFr, it: firstDriveIt, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'square.py',
      title: { de: 'Ein Quadrat fahren', fr: 'Parcourir un carré', it: 'Percorrere un quadrato', en: 'Drive a square' },
      source: { de: squareDe, fr: squareFr, it: squareIt, en: squareEn },
      course: 'empty',
    },
    {
      file: 'lights.py',
      title: { de: 'Lichter', fr: 'Lumières', it: 'Luci', en: 'Lights' },
      source: { de: lightsDe, fr: lightsFr, it: lightsIt, en: lightsEn },
    },
    {
      file: 'ring.py',
      title: { de: 'Lichterring', fr: 'Anneau lumineux', it: 'Anello di luci', en: 'Ring of lights' },
      source: { de: ringDe, fr: ringFr, it: ringIt, en: ringEn },
      course: 'empty',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', fr: 'Un servo', it: 'Un servo', en: 'A servo' },
      source: { de: servoDe, fr: servoFr, it: servoIt, en: servoEn },
      course: 'empty',
      options: { S1: 'claw' },
    },
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
