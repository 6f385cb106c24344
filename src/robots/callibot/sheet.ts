/** Calli:bot: what the gallery tells about it. */
import type { RobotSheet, WiringRow } from '../robot';
import { lightsTable, motorsTable, registersTable, silentTable } from './registers';
import bumperDe from './examples/bumper.de.py?raw';
import bumperFr from './examples/bumper.fr.py?raw';
import bumperIt from './examples/bumper.it.py?raw';
import bumperEn from './examples/bumper.en.py?raw';
import encoderDe from './examples/encoder.de.py?raw';
import encoderFr from './examples/encoder.fr.py?raw';
import encoderIt from './examples/encoder.it.py?raw';
import encoderEn from './examples/encoder.en.py?raw';
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

const wiring: readonly WiringRow[] = [
  {
    part: {
      de: 'Verbindung zum Calliope mini',
      fr: 'Liaison avec le Calliope mini',
      it: 'Collegamento al Calliope mini',
      en: 'Link to the Calliope mini',
    },
    at: 'A0: SCL, SDA',
    note: {
      de: 'ein Kabel für alles: der I2C-Bus; die Teile darunter haben Adressen auf ihm',
      fr: 'un seul câble pour tout : le bus I2C ; les éléments ci-dessous y ont leurs adresses',
      it: 'un solo cavo per tutto: il bus I2C; le parti qui sotto vi hanno i loro indirizzi',
      en: 'one cable for everything: the I2C bus; the parts below have addresses on it',
    },
  },
  {
    part: { de: 'Motoren', fr: 'Moteurs', it: 'Motori', en: 'Motors' },
    at: '0x20, 0x22',
    note: {
      de: 'Kraft 0 bis 255, Richtung 0 vorwärts, 1 rückwärts',
      fr: 'puissance de 0 à 255, direction 0 en avant, 1 en arrière',
      it: 'potenza da 0 a 255, direzione 0 avanti, 1 indietro',
      en: 'power 0 to 255, direction 0 forward, 1 backward',
    },
  },
  {
    part: {
      de: 'Rote Lichter vorn',
      fr: 'Lumières rouges à l’avant',
      it: 'Luci rosse davanti',
      en: 'Red front lights',
    },
    at: '0x21, 0x22',
    note: { de: '1 = ein', fr: '1 = allumé', it: '1 = acceso', en: '1 = on' },
  },
  {
    part: {
      de: 'Vier Farblichter unten',
      fr: 'Quatre LED de couleur dessous',
      it: 'Quattro LED colorati sotto',
      en: 'Four colour lights below',
    },
    at: '0x21, 0x22',
    note: {
      de: '1 vorn links, 2 hinten links, 3 hinten rechts, 4 vorn rechts',
      fr: '1 avant gauche, 2 arrière gauche, 3 arrière droite, 4 avant droite',
      it: '1 davanti a sinistra, 2 dietro a sinistra, 3 dietro a destra, 4 davanti a destra',
      en: '1 front left, 2 rear left, 3 rear right, 4 front right',
    },
  },
  {
    part: {
      de: 'Liniensensoren links, rechts',
      fr: 'Capteurs de ligne à gauche, à droite',
      it: 'Sensori di linea a sinistra, a destra',
      en: 'Line sensors left, right',
    },
    at: '0x21, 0x22',
    note: {
      de: '1 = heller Boden; dann leuchtet ihr blaues Licht',
      fr: '1 = sol clair ; leur lumière bleue est alors allumée',
      it: '1 = pavimento chiaro; allora la loro luce blu è accesa',
      en: '1 = light ground; then their blue light is on',
    },
  },
  {
    part: {
      de: 'Stossfänger links, rechts (2 und 2E)',
      fr: 'Pare-chocs à gauche, à droite (2 et 2E)',
      it: 'Paraurti a sinistra, a destra (2 e 2E)',
      en: 'Bumper left, right (2 and 2E)',
    },
    at: '0x21, 0x22',
    note: {
      de: '1 = gedrückt; der Roboter trägt ihn, sobald ein Programm die Sensoren liest (Linie, Abstand oder Stossfänger): Alle drei stehen in derselben Antwort',
      fr: '1 = enfoncé ; le robot le porte dès qu’un programme lit les capteurs (ligne, distance ou pare-chocs) : les trois se trouvent dans la même réponse',
      it: '1 = premuto; il robot lo porta appena un programma legge i sensori (linea, distanza o paraurti): tutti e tre stanno nella stessa risposta',
      en: '1 = pressed; the robot carries it once a program reads the sensors (line, distance or bumper): all three stand in the same answer',
    },
  },
  {
    part: { de: 'Ultraschallsensor', fr: 'Capteur à ultrasons', it: 'Sensore a ultrasuoni', en: 'Ultrasonic sensor' },
    at: '0x21, 0x22',
    note: {
      de: 'Abstand in Millimetern',
      fr: 'distance en millimètres',
      it: 'distanza in millimetri',
      en: 'distance in millimetres',
    },
  },
  {
    part: {
      de: 'Radzähler links, rechts (2E)',
      fr: 'Compteurs de roue à gauche, à droite (2E)',
      it: 'Contatori delle ruote a sinistra, a destra (2E)',
      en: 'Wheel encoders left, right (2E)',
    },
    at: '0x22',
    note: {
      de: '450 Pulse für eine Umdrehung, 31.5 für 1 cm',
      fr: '450 impulsions pour un tour, 31,5 pour 1 cm',
      it: '450 impulsi per un giro, 31.5 per 1 cm',
      en: '450 pulses for one turn, 31.5 for 1 cm',
    },
  },
  {
    part: { de: 'Servos S1, S2', fr: 'Servos S1, S2', it: 'Servo S1, S2', en: 'Servos S1, S2' },
    at: '0x20',
    note: {
      de: 'Winkel 0 bis 180 Grad; callibot hat keinen Befehl dafür: i2c.write(0x20, bytes([0x14, 90])) stellt S1 auf 90 Grad',
      fr: 'angle de 0 à 180 degrés ; callibot n’a pas de commande pour cela : i2c.write(0x20, bytes([0x14, 90])) met S1 à 90 degrés',
      it: 'angolo da 0 a 180 gradi; callibot non ha un comando per questo: i2c.write(0x20, bytes([0x14, 90])) mette S1 a 90 gradi',
      en: 'angle 0 to 180 degrees; callibot has no command for it: i2c.write(0x20, bytes([0x14, 90])) sets S1 to 90 degrees',
    },
  },
];

export const callibotSheet: RobotSheet = {
  robot: 'callibot',
  about: {
    de: 'Der Roboter von Knotech für den Calliope mini, der flach auf ihm liegt. Er hat zwei Motoren, zwei Liniensensoren, Ultraschall, einen Stossfänger, rote und farbige Lichter. Der 2E zählt auch mit, wie weit sich seine Räder drehen.',
    fr: 'Le robot de Knotech pour le Calliope mini, qui est posé à plat sur lui. Il a deux moteurs, deux capteurs de ligne, des ultrasons, un pare-chocs, des lumières rouges et colorées. Le 2E compte aussi de combien ses roues tournent.',
    it: 'Il robot di Knotech per il Calliope mini, che vi è appoggiato sopra in piano. Ha due motori, due sensori di linea, ultrasuoni, un paraurti, luci rosse e colorate. Il 2E conta anche di quanto girano le sue ruote.',
    en: 'The robot by Knotech for the Calliope mini, which lies flat on it. It has two motors, two line sensors, an ultrasonic sensor, a bumper, red and coloured lights. The 2E also counts how far its wheels turn.',
  },
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
      file: 'bumper.py',
      title: {
        de: 'Anstossen und ausweichen',
        fr: 'Toucher et éviter',
        it: 'Urtare ed evitare',
        en: 'Bump and turn away',
      },
      source: { de: bumperDe, fr: bumperFr, it: bumperIt, en: bumperEn },
      course: 'empty',
    },
    {
      file: 'lights.py',
      title: { de: 'Lichter', fr: 'Lumières', it: 'Luci', en: 'Lights' },
      source: { de: lightsDe, fr: lightsFr, it: lightsIt, en: lightsEn },
    },
    {
      file: 'encoder.py',
      title: {
        de: 'Genau einen halben Meter',
        fr: 'Exactement un demi-mètre',
        it: 'Esattamente mezzo metro',
        en: 'Exactly half a metre',
      },
      source: { de: encoderDe, fr: encoderFr, it: encoderIt, en: encoderEn },
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
  sizeNote: { de: 'ohne Stossfänger', fr: 'sans pare-chocs', it: 'senza paraurti', en: 'without its bumper' },
  wiring,
  registers: [motorsTable, lightsTable, registersTable, silentTable],
};
