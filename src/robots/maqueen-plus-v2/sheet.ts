/** Maqueen Plus V2: what the gallery tells about it. */
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

export const maqueenPlusV2Sheet: RobotSheet = {
  robot: 'maqueen-plus-v2',
  about: {
    de: 'Der grössere Roboter von DFRobot, mit Metallrahmen und Akku. Fünf Liniensensoren messen auch, wie hell der Boden ist. Dazu kommen Ultraschall, rote und farbige Lichter und drei Anschlüsse für Servos.',
    fr: 'Le plus grand robot de DFRobot, avec un cadre en métal et un accu. Ses cinq capteurs de ligne mesurent aussi la clarté du sol. S’y ajoutent des ultrasons, des lumières rouges et colorées et trois connecteurs pour servos.',
    it: 'Il robot più grande di DFRobot, con telaio di metallo e batteria ricaricabile. I cinque sensori di linea misurano anche quanto è chiaro il pavimento. Inoltre ha ultrasuoni, luci rosse e colorate e tre connettori per servo.',
    en: 'The larger robot by DFRobot, with a metal frame and a rechargeable battery. Its five line sensors also measure how light the ground is. It has an ultrasonic sensor, red and coloured lights and three servo ports.',
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
    {
      part: {
        de: 'Motoren, rote Lichter, Liniensensoren',
        fr: 'Moteurs, lumières rouges, capteurs de ligne',
        it: 'Motori, luci rosse, sensori di linea',
        en: 'Motors, red lights, line sensors',
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
      at: 'P13',
    },
    {
      part: { de: 'Ultraschall: Echo', fr: 'Ultrasons : écho', it: 'Ultrasuoni: eco', en: 'Ultrasonic: echo' },
      at: 'P14',
      note: {
        de: 'Puls von 58 µs für jeden cm',
        fr: 'impulsion de 58 µs pour chaque cm',
        it: 'impulso di 58 µs per ogni cm',
        en: 'pulse of 58 µs for each cm',
      },
    },
    {
      part: {
        de: 'Vier Farblichter',
        fr: 'Quatre LED de couleur',
        it: 'Quattro LED colorati',
        en: 'Four colour lights',
      },
      at: 'P15',
      note: {
        de: 'NeoPixel: 0 vorn links, 1 hinten links, 2 hinten rechts, 3 vorn rechts',
        fr: 'NeoPixel : 0 avant gauche, 1 arrière gauche, 2 arrière droite, 3 avant droite',
        it: 'NeoPixel: 0 davanti a sinistra, 1 dietro a sinistra, 2 dietro a destra, 3 davanti a destra',
        en: 'NeoPixel: 0 front left, 1 back left, 2 back right, 3 front right',
      },
    },
    {
      part: { de: 'Servos P0, P1, P2', fr: 'Servos P0, P1, P2', it: 'Servo P0, P1, P2', en: 'Servos P0, P1, P2' },
      at: 'P0, P1, P2',
      note: {
        de: 'Puls von 0.5 bis 2.5 ms alle 20 ms: 0 bis 180°',
        fr: 'impulsion de 0,5 à 2,5 ms toutes les 20 ms : 0 à 180°',
        it: 'impulso da 0.5 a 2.5 ms ogni 20 ms: da 0 a 180°',
        en: 'pulse of 0.5 to 2.5 ms every 20 ms: 0 to 180°',
      },
    },
    {
      part: { de: 'Summer', fr: 'Buzzer', it: 'Cicalino', en: 'Buzzer' },
      at: 'P0',
      note: {
        de: 'derselbe Pin wie der erste Servo',
        fr: 'la même broche que le premier servo',
        it: 'lo stesso pin del primo servo',
        en: 'the same pin as the first servo',
      },
    },
    {
      part: {
        de: 'Infrarotempfänger',
        fr: 'Récepteur infrarouge',
        it: 'Ricevitore a infrarossi',
        en: 'Infrared receiver',
      },
      at: 'P16',
      note: {
        de: 'hört hier keine Fernbedienung',
        fr: 'n’entend aucune télécommande ici',
        it: 'qui non sente nessun telecomando',
        en: 'hears no remote control here',
      },
    },
  ],
  registers: [
    {
      address: 0x10,
      title: {
        de: 'Steuerung des Roboters',
        fr: 'Commande du robot',
        it: 'Controllo del robot',
        en: 'The robot’s controller',
      },
      rows: [
        {
          register: '0x00',
          access: 'RW',
          meaning: {
            de: 'linker Motor: 0 vorwärts, 1 rückwärts',
            fr: 'moteur gauche : 0 en avant, 1 en arrière',
            it: 'motore sinistro: 0 avanti, 1 indietro',
            en: 'left motor: 0 forward, 1 backward',
          },
        },
        {
          register: '0x01',
          access: 'RW',
          meaning: {
            de: 'linker Motor: Kraft 0–255',
            fr: 'moteur gauche : puissance 0–255',
            it: 'motore sinistro: potenza 0–255',
            en: 'left motor: power 0–255',
          },
        },
        {
          register: '0x02',
          access: 'RW',
          meaning: {
            de: 'rechter Motor: 0 vorwärts, 1 rückwärts',
            fr: 'moteur droit : 0 en avant, 1 en arrière',
            it: 'motore destro: 0 avanti, 1 indietro',
            en: 'right motor: 0 forward, 1 backward',
          },
        },
        {
          register: '0x03',
          access: 'RW',
          meaning: {
            de: 'rechter Motor: Kraft 0–255',
            fr: 'moteur droit : puissance 0–255',
            it: 'motore destro: potenza 0–255',
            en: 'right motor: power 0–255',
          },
        },
        {
          register: '0x0B',
          access: 'RW',
          meaning: {
            de: 'linkes rotes Licht: 0 aus, 1 ein',
            fr: 'lumière rouge de gauche : 0 éteint, 1 allumé',
            it: 'luce rossa di sinistra: 0 spento, 1 acceso',
            en: 'left red light: 0 off, 1 on',
          },
        },
        {
          register: '0x0C',
          access: 'RW',
          meaning: {
            de: 'rechtes rotes Licht: 0 aus, 1 ein',
            fr: 'lumière rouge de droite : 0 éteint, 1 allumé',
            it: 'luce rossa di destra: 0 spento, 1 acceso',
            en: 'right red light: 0 off, 1 on',
          },
        },
        {
          register: '0x1D',
          access: 'R',
          meaning: {
            de: 'Liniensensoren: Bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2; 1 auf dunklem Boden',
            fr: 'capteurs de ligne : bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2 ; 1 sur un sol sombre',
            it: 'sensori di linea: bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2; 1 su pavimento scuro',
            en: 'line sensors: bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2; 1 on dark ground',
          },
        },
        {
          register: '0x1E … 0x27',
          access: 'R',
          meaning: {
            de: 'Helligkeit von R2, R1, M, L1, L2, je zwei Bytes, tiefes Byte zuerst',
            fr: 'luminosité de R2, R1, M, L1, L2, deux octets chacun, octet de poids faible d’abord',
            it: 'luminosità di R2, R1, M, L1, L2, due byte ognuno, prima il byte basso',
            en: 'brightness of R2, R1, M, L1, L2, two bytes each, low byte first',
          },
        },
        {
          register: '0x32',
          access: 'R',
          meaning: {
            de: 'Länge des Versionstextes',
            fr: 'longueur du texte de version',
            it: 'lunghezza del testo di versione',
            en: 'length of the version text',
          },
        },
        {
          register: '0x33 …',
          access: 'R',
          meaning: {
            de: 'Versionstext, zum Beispiel MBT0021-EN-2.1',
            fr: 'texte de version, par exemple MBT0021-EN-2.1',
            it: 'testo di versione, per esempio MBT0021-EN-2.1',
            en: 'version text, such as MBT0021-EN-2.1',
          },
        },
      ],
    },
  ],
};
