/** Calli:bot: what the gallery tells about it. */
import type { RegisterTable, RobotSheet, WiringRow } from '../robot';
import bumperDe from './examples/bumper.de.py?raw';
import bumperEn from './examples/bumper.en.py?raw';
import encoderDe from './examples/encoder.de.py?raw';
import encoderEn from './examples/encoder.en.py?raw';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineEn from './examples/line.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoEn from './examples/servo.en.py?raw';

const wiring: readonly WiringRow[] = [
  {
    part: { de: 'Verbindung zum Calliope mini', en: 'Link to the Calliope mini' },
    at: 'A0: SCL, SDA',
    note: {
      de: 'ein Kabel für alles: der I2C-Bus; die Teile darunter haben Adressen auf ihm',
      en: 'one cable for everything: the I2C bus; the parts below have addresses on it',
    },
  },
  {
    part: { de: 'Motoren', en: 'Motors' },
    at: '0x20, 0x22',
    note: {
      de: 'Kraft 0 bis 255, Richtung 0 vorwärts, 1 rückwärts',
      en: 'power 0 to 255, direction 0 forward, 1 backward',
    },
  },
  {
    part: { de: 'Rote Lichter vorn', en: 'Red front lights' },
    at: '0x21, 0x22',
    note: { de: '1 = ein', en: '1 = on' },
  },
  {
    part: { de: 'Vier Farblichter unten', en: 'Four colour lights below' },
    at: '0x21, 0x22',
    note: {
      de: '1 vorn links, 2 hinten links, 3 hinten rechts, 4 vorn rechts',
      en: '1 front left, 2 rear left, 3 rear right, 4 front right',
    },
  },
  {
    part: { de: 'Liniensensoren links, rechts', en: 'Line sensors left, right' },
    at: '0x21, 0x22',
    note: {
      de: '1 = heller Boden; dann leuchtet ihr blaues Licht',
      en: '1 = light ground; then their blue light is on',
    },
  },
  {
    part: { de: 'Stossfänger links, rechts (2 und 2E)', en: 'Bumper left, right (2 and 2E)' },
    at: '0x21, 0x22',
    note: {
      de: '1 = gedrückt; der Roboter trägt ihn, sobald ein Programm die Sensoren liest (Linie, Abstand oder Stossfänger): Alle drei stehen in derselben Antwort',
      en: '1 = pressed; the robot carries it once a program reads the sensors (line, distance or bumper): all three stand in the same answer',
    },
  },
  {
    part: { de: 'Ultraschallsensor', en: 'Ultrasonic sensor' },
    at: '0x21, 0x22',
    note: { de: 'Abstand in Millimetern', en: 'distance in millimetres' },
  },
  {
    part: { de: 'Radzähler links, rechts (2E)', en: 'Wheel encoders left, right (2E)' },
    at: '0x22',
    note: { de: '450 Pulse für eine Umdrehung, 31.5 für 1 cm', en: '450 pulses for one turn, 31.5 for 1 cm' },
  },
  {
    part: { de: 'Servos S1, S2', en: 'Servos S1, S2' },
    at: '0x20',
    note: {
      de: 'Winkel 0 bis 180 Grad; callibot hat keinen Befehl dafür: i2c.write(0x20, bytes([0x14, 90])) stellt S1 auf 90 Grad',
      en: 'angle 0 to 180 degrees; callibot has no command for it: i2c.write(0x20, bytes([0x14, 90])) sets S1 to 90 degrees',
    },
  },
];

const motorsTable: RegisterTable = {
  address: 0x20,
  title: { de: 'Motoren und Servos', en: 'Motors and servos' },
  rows: [
    { register: '0x00', access: 'W', meaning: { de: 'links: Richtung, Kraft', en: 'left: direction, power' } },
    { register: '0x02', access: 'W', meaning: { de: 'rechts: Richtung, Kraft', en: 'right: direction, power' } },
    { register: '0x14', access: 'W', meaning: { de: 'Servo S1: Winkel', en: 'servo S1: angle' } },
    { register: '0x15', access: 'W', meaning: { de: 'Servo S2: Winkel', en: 'servo S2: angle' } },
  ],
};

const lightsTable: RegisterTable = {
  address: 0x21,
  title: { de: 'Lichter und Sensoren', en: 'Lights and sensors' },
  rows: [
    {
      register: '0x00',
      access: 'W',
      meaning: { de: 'rote Lichter: Bit 0 links, Bit 1 rechts', en: 'red lights: bit 0 left, bit 1 right' },
    },
    {
      register: '0x01 … 0x04',
      access: 'W',
      meaning: {
        de: 'Farblichter: Bit 0 grün, 1 rot, 2 blau, Bits 4 bis 7 Helligkeit',
        en: 'colour lights: bit 0 green, 1 red, 2 blue, bits 4 to 7 brightness',
      },
    },
    {
      register: 'Byte 0',
      access: 'R',
      meaning: {
        de: 'Bit 0 Linie rechts, 1 Linie links, 2 Stossfänger rechts, 3 Stossfänger links, 4 Taste ON, 5 Taste OFF; Bit 7 ist 1, beim Calli:bot 1 ist es 0',
        en: 'bit 0 line right, 1 line left, 2 bumper right, 3 bumper left, 4 key ON, 5 key OFF; bit 7 is 1, on the Calli:bot 1 it is 0',
      },
    },
    {
      register: 'Byte 1, 2',
      access: 'R',
      meaning: { de: 'Abstand in mm, hohes Byte zuerst', en: 'distance in mm, high byte first' },
    },
  ],
};

const registersTable: RegisterTable = {
  address: 0x22,
  title: { de: 'Alle Teile ausser Servos (Calli:bot 2 und 2E)', en: 'All parts but servos (Calli:bot 2 and 2E)' },
  rows: [
    { register: '0x01', access: 'W', meaning: { de: 'Motoren und Lichter aus', en: 'motors and lights off' } },
    {
      register: '0x02',
      access: 'W',
      meaning: {
        de: 'welcher Motor (1 links, 2 rechts, 3 beide), Richtung, Kraft; bei 3 folgen Richtung und Kraft für rechts',
        en: 'which motor (1 left, 2 right, 3 both), direction, power; with 3, direction and power for the right one follow',
      },
    },
    {
      register: '0x03',
      access: 'W',
      meaning: {
        de: 'Farblicht 1 bis 4: Rot, Grün, Blau; rotes Licht 5 links, 6 rechts: Helligkeit; je 0 bis 16',
        en: 'colour light 1 to 4: red, green, blue; red light 5 left, 6 right: brightness; 0 to 16 each',
      },
    },
    {
      register: '0x05',
      access: 'W',
      meaning: {
        de: 'Radzähler auf 0: 1 links, 2 rechts, 3 beide (2E)',
        en: 'encoders to 0: 1 left, 2 right, 3 both (2E)',
      },
    },
    {
      register: '0x80',
      access: 'R',
      meaning: { de: 'wie Byte 0 an 0x21, aber Bit 7 ist 0', en: 'as byte 0 at 0x21, but bit 7 is 0' },
    },
    {
      register: '0x81 …',
      access: 'R',
      meaning: {
        de: 'Jede Antwort beginnt mit der Nummer des Registers, dann folgt der Wert, tiefes Byte zuerst.',
        en: 'Every answer begins with the number of the register; then comes the value, low byte first.',
      },
    },
    {
      register: '0x81',
      access: 'R',
      meaning: { de: 'Abstand in mm', en: 'distance in mm' },
    },
    {
      register: '0x82',
      access: 'R',
      meaning: {
        de: 'Typ (2 = Calli:bot 2, 3 = 2E), Firmware 4 Bytes, Seriennummer 4 Bytes',
        en: 'type (2 = Calli:bot 2, 3 = 2E), firmware 4 bytes, serial number 4 bytes',
      },
    },
    {
      register: '0x83',
      access: 'R',
      meaning: { de: 'Spannung der Batterie in mV (2E)', en: 'voltage of the battery in mV (2E)' },
    },
    {
      register: '0x84',
      access: 'R',
      meaning: {
        de: 'Spannung der Liniensensoren in mV, rechts, dann links',
        en: 'voltage of the line sensors in mV, right, then left',
      },
    },
    {
      register: '0x91',
      access: 'R',
      meaning: {
        de: 'Radzähler links, dann rechts, je 4 Bytes, rückwärts negativ (2E)',
        en: 'encoders left, then right, 4 bytes each, negative backward (2E)',
      },
    },
  ],
};

const silentTable: RegisterTable = {
  address: 0x23,
  lastAddress: 0x27,
  title: { de: 'Ohne bekannte Aufgabe (Calli:bot 2 und 2E)', en: 'No known purpose (Calli:bot 2 and 2E)' },
  rows: [
    {
      register: '0x00 … 0xFF',
      access: 'RW',
      meaning: {
        de: 'antworten, wenn ein Programm den Bus absucht; Schreiben bewirkt nichts, Lesen gibt 0',
        en: 'answer when a program scans the bus; writing does nothing, reading gives 0',
      },
    },
  ],
};

export const callibotSheet: RobotSheet = {
  robot: 'callibot',
  about: {
    de: 'Der Roboter von Knotech für den Calliope mini, der flach auf ihm liegt. Er hat zwei Motoren, zwei Liniensensoren, Ultraschall, einen Stossfänger, rote und farbige Lichter. Der 2E zählt auch mit, wie weit sich seine Räder drehen.',
    en: 'The robot by Knotech for the Calliope mini, which lies flat on it. It has two motors, two line sensors, an ultrasonic sensor, a bumper, red and coloured lights. The 2E also counts how far its wheels turn.',
  },
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', en: 'First drive' },
      source: { de: firstDriveDe, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'line.py',
      title: { de: 'Einer Linie folgen', en: 'Follow a line' },
      source: { de: lineDe, en: lineEn },
      course: 'closed-line',
    },
    {
      file: 'bumper.py',
      title: { de: 'Anstossen und ausweichen', en: 'Bump and turn away' },
      source: { de: bumperDe, en: bumperEn },
      course: 'empty',
    },
    { file: 'lights.py', title: { de: 'Lichter', en: 'Lights' }, source: { de: lightsDe, en: lightsEn } },
    {
      file: 'encoder.py',
      title: { de: 'Genau einen halben Meter', en: 'Exactly half a metre' },
      source: { de: encoderDe, en: encoderEn },
      course: 'empty',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', en: 'A servo' },
      source: { de: servoDe, en: servoEn },
      course: 'empty',
      options: { S1: 'claw' },
    },
  ],
  sizeNote: { de: 'ohne Stossfänger', en: 'without its bumper' },
  wiring,
  registers: [motorsTable, lightsTable, registersTable, silentTable],
};
