/** Maqueen Plus V1: what the gallery tells about it. */
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

const controller: RegisterTable = {
  address: 0x10,
  title: {
    de: 'Steuerung des Roboters',
    fr: 'Commande du robot',
    it: 'Controllo del robot',
    en: 'The robot’s controller',
  },
  rows: [
    {
      register: '0x00, 0x02',
      access: 'RW',
      meaning: {
        de: 'Richtung links, rechts: 0 halt, 1 vorwärts, 2 rückwärts',
        fr: 'direction gauche, droite : 0 arrêt, 1 en avant, 2 en arrière',
        it: 'direzione sinistra, destra: 0 fermo, 1 avanti, 2 indietro',
        en: 'direction left, right: 0 stop, 1 forward, 2 backward',
      },
    },
    {
      register: '0x01, 0x03',
      access: 'RW',
      meaning: {
        de: 'Kraft links, rechts: 0 bis 255',
        fr: 'puissance gauche, droite : 0 à 255',
        it: 'potenza sinistra, destra: da 0 a 255',
        en: 'power left, right: 0 to 255',
      },
    },
    {
      register: '0x04 … 0x07',
      access: 'RW',
      meaning: {
        de: 'Pulse der Räder, links, dann rechts, hohes Byte zuerst; 80 sind eine Umdrehung. Schreiben stellt sie auf 0.',
        fr: 'impulsions des roues, gauche, puis droite, octet de poids fort d’abord ; 80 font un tour. Écrire les remet à 0.',
        it: 'impulsi delle ruote, sinistra, poi destra, prima il byte alto; 80 sono un giro. Scrivere li riporta a 0.',
        en: 'pulses of the wheels, left, then right, high byte first; 80 are one turn. A write sets them to 0.',
      },
    },
    {
      register: '0x0A',
      access: 'RW',
      meaning: {
        de: '1 = der Roboter hält sein Tempo selbst',
        fr: '1 = le robot garde lui-même sa vitesse',
        it: '1 = il robot mantiene da solo la sua velocità',
        en: '1 = the robot keeps its speed by itself',
      },
    },
    {
      register: '0x0B, 0x0C',
      access: 'RW',
      meaning: {
        de: 'Licht links, rechts: 1 rot, 2 grün, 3 gelb, 4 blau, 5 rosa, 6 türkis, 7 weiss, 8 aus',
        fr: 'lumière gauche, droite : 1 rouge, 2 vert, 3 jaune, 4 bleu, 5 rose, 6 turquoise, 7 blanc, 8 éteint',
        it: 'luce sinistra, destra: 1 rosso, 2 verde, 3 giallo, 4 blu, 5 rosa, 6 turchese, 7 bianco, 8 spento',
        en: 'light left, right: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, 8 off',
      },
    },
    {
      register: '0x14 … 0x16',
      access: 'RW',
      meaning: {
        de: 'Winkel der Servos S1, S2, S3 in Grad',
        fr: 'angle des servos S1, S2, S3 en degrés',
        it: 'angolo dei servo S1, S2, S3 in gradi',
        en: 'angle of the servos S1, S2, S3 in degrees',
      },
    },
    {
      register: '0x1D',
      access: 'R',
      meaning: {
        de: 'Liniensensoren: Bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3; 1 auf dunklem Boden',
        fr: 'capteurs de ligne : bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3 ; 1 sur un sol sombre',
        it: 'sensori di linea: bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3; 1 su pavimento scuro',
        en: 'line sensors: bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3; 1 on dark ground',
      },
    },
    {
      register: '0x1E … 0x29',
      access: 'R',
      meaning: {
        de: 'Helligkeit unter L3, L2, L1, R1, R2, R3, je zwei Bytes, hohes Byte zuerst; bis 4095',
        fr: 'luminosité sous L3, L2, L1, R1, R2, R3, deux octets chacun, octet de poids fort d’abord ; jusqu’à 4095',
        it: 'luminosità sotto L3, L2, L1, R1, R2, R3, due byte ognuno, prima il byte alto; fino a 4095',
        en: 'brightness below L3, L2, L1, R1, R2, R3, two bytes each, high byte first; up to 4095',
      },
    },
    {
      register: '0x32, 0x33 …',
      access: 'R',
      meaning: {
        de: 'Länge des Versionstextes, dann der Text',
        fr: 'longueur du texte de version, puis le texte',
        it: 'lunghezza del testo di versione, poi il testo',
        en: 'length of the version text, then the text',
      },
    },
  ],
};

export const maqueenPlusV1Sheet: RobotSheet = {
  robot: 'maqueen-plus-v1',
  about: {
    de: 'Der erste Maqueen Plus von DFRobot. Er hat sechs Liniensensoren, farbige Lichter vorn, Ultraschall und drei Anschlüsse für Servos. Seine Räder zählen mit, wie weit sie sich drehen, und er kann sein Tempo selbst halten.',
    fr: 'Le premier Maqueen Plus de DFRobot. Il a six capteurs de ligne, des lumières colorées à l’avant, des ultrasons et trois connecteurs pour servos. Ses roues comptent de combien elles tournent, et il peut garder lui-même sa vitesse.',
    it: 'Il primo Maqueen Plus di DFRobot. Ha sei sensori di linea, luci colorate davanti, ultrasuoni e tre connettori per servo. Le sue ruote contano di quanto girano, e può mantenere da solo la sua velocità.',
    en: 'The first Maqueen Plus by DFRobot. It has six line sensors, coloured lights in front, an ultrasonic sensor and three servo ports. Its wheels count how far they turn, and it can keep its speed by itself.',
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
    {
      part: {
        de: 'Motoren, Lichter, Servos, Liniensensoren, Radzähler',
        fr: 'Moteurs, lumières, servos, capteurs de ligne, compteurs de roue',
        it: 'Motori, luci, servo, sensori di linea, contatori delle ruote',
        en: 'Motors, lights, servos, line sensors, wheel encoders',
      },
      at: 'I2C 0x10',
      note: {
        de: 'SCL an P19, SDA an P20',
        fr: 'SCL à P19, SDA à P20',
        it: 'SCL a P19, SDA a P20',
        en: 'SCL at P19, SDA at P20',
      },
    },
    {
      part: {
        de: 'Ultraschall: Auslöser',
        fr: 'Ultrasons : déclencheur',
        it: 'Ultrasuoni: comando',
        en: 'Ultrasonic: trigger',
      },
      at: 'P1',
    },
    {
      part: { de: 'Ultraschall: Echo', fr: 'Ultrasons : écho', it: 'Ultrasuoni: eco', en: 'Ultrasonic: echo' },
      at: 'P2',
      note: {
        de: 'Puls von 58 µs für jeden cm',
        fr: 'impulsion de 58 µs pour chaque cm',
        it: 'impulso di 58 µs per ogni cm',
        en: 'pulse of 58 µs for each cm',
      },
    },
    { part: { de: 'Summer', fr: 'Buzzer', it: 'Cicalino', en: 'Buzzer' }, at: 'P0' },
  ],
  registers: [controller],
};
