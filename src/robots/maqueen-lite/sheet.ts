/** Maqueen Lite: what the gallery tells about it. */
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

export const maqueenLiteSheet: RobotSheet = {
  robot: 'maqueen-lite',
  about: {
    de: 'Der kleine Roboter von DFRobot, den viele Schulen haben. Er hat zwei Motoren, zwei Liniensensoren, Ultraschall, rote und farbige Lichter und zwei Anschlüsse für Servos. Programme für seine Ausgaben V3, V4 und V5 laufen.',
    fr: 'Le petit robot de DFRobot que beaucoup d’écoles possèdent. Il a deux moteurs, deux capteurs de ligne, des ultrasons, des lumières rouges et colorées et deux connecteurs pour servos. Les programmes pour ses versions V3, V4 et V5 fonctionnent.',
    it: 'Il piccolo robot di DFRobot che molte scuole possiedono. Ha due motori, due sensori di linea, ultrasuoni, luci rosse e colorate e due connettori per servo. Funzionano i programmi per le sue versioni V3, V4 e V5.',
    en: 'The small robot by DFRobot that many schools have. It has two motors, two line sensors, an ultrasonic sensor, red and coloured lights and two servo ports. Programs for its issues V3, V4 and V5 run.',
  },
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
    {
      part: { de: 'Motoren und Servos', fr: 'Moteurs et servos', it: 'Motori e servo', en: 'Motors and servos' },
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
        de: 'Rotes Licht links',
        fr: 'Lumière rouge de gauche',
        it: 'Luce rossa di sinistra',
        en: 'Left red light',
      },
      at: 'P8',
      note: { de: '1 ein, 0 aus', fr: '1 allumé, 0 éteint', it: '1 acceso, 0 spento', en: '1 on, 0 off' },
    },
    {
      part: {
        de: 'Rotes Licht rechts',
        fr: 'Lumière rouge de droite',
        it: 'Luce rossa di destra',
        en: 'Right red light',
      },
      at: 'P12',
      note: { de: '1 ein, 0 aus', fr: '1 allumé, 0 éteint', it: '1 acceso, 0 spento', en: '1 on, 0 off' },
    },
    {
      part: {
        de: 'Liniensensor links',
        fr: 'Capteur de ligne de gauche',
        it: 'Sensore di linea di sinistra',
        en: 'Left line sensor',
      },
      at: 'P13',
      note: {
        de: '1 auf hellem, 0 auf dunklem Boden',
        fr: '1 sur un sol clair, 0 sur un sol sombre',
        it: '1 su pavimento chiaro, 0 su pavimento scuro',
        en: '1 on light, 0 on dark ground',
      },
    },
    {
      part: {
        de: 'Liniensensor rechts',
        fr: 'Capteur de ligne de droite',
        it: 'Sensore di linea di destra',
        en: 'Right line sensor',
      },
      at: 'P14',
      note: {
        de: '1 auf hellem, 0 auf dunklem Boden',
        fr: '1 sur un sol clair, 0 sur un sol sombre',
        it: '1 su pavimento chiaro, 0 su pavimento scuro',
        en: '1 on light, 0 on dark ground',
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
    { part: { de: 'Summer', fr: 'Buzzer', it: 'Cicalino', en: 'Buzzer' }, at: 'P0' },
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
          register: '0x0B, 0x0C',
          access: 'RW',
          meaning: {
            de: 'V5: Farbe des Lichts links, rechts: 1 rot, 2 grün, 3 gelb, 4 blau, 5 violett, 6 türkis, 7 weiss, 8 aus',
            fr: 'V5 : couleur de la lumière gauche, droite : 1 rouge, 2 vert, 3 jaune, 4 bleu, 5 violet, 6 cyan, 7 blanc, 8 éteint',
            it: 'V5: colore della luce sinistra, destra: 1 rosso, 2 verde, 3 giallo, 4 blu, 5 viola, 6 ciano, 7 bianco, 8 spento',
            en: 'V5: colour of the left, right light: 1 red, 2 green, 3 yellow, 4 blue, 5 purple, 6 cyan, 7 white, 8 off',
          },
        },
        {
          register: '0x0D … 0x12',
          access: 'RW',
          meaning: {
            de: 'V5: wie oft und wie schnell diese Lichter blinken und die Farbe wechseln',
            fr: 'V5 : combien de fois et à quelle vitesse ces lumières clignotent et changent de couleur',
            it: 'V5: quante volte e con che velocità queste luci lampeggiano e cambiano colore',
            en: 'V5: how often and how fast these lights flash and change their colour',
          },
        },
        {
          register: '0x14',
          access: 'RW',
          meaning: {
            de: 'Servo S1: 0–180 Grad',
            fr: 'servo S1 : 0–180 degrés',
            it: 'servo S1: 0–180 gradi',
            en: 'servo S1: 0–180 degrees',
          },
        },
        {
          register: '0x15',
          access: 'RW',
          meaning: {
            de: 'Servo S2: 0–180 Grad',
            fr: 'servo S2 : 0–180 degrés',
            it: 'servo S2: 0–180 gradi',
            en: 'servo S2: 0–180 degrees',
          },
        },
        {
          register: '0x1D',
          access: 'R',
          meaning: {
            de: 'V5: Liniensensoren: Bit 2 links, Bit 1 Mitte, Bit 0 rechts; 1 auf Schwarz',
            fr: 'V5 : capteurs de ligne : bit 2 gauche, bit 1 milieu, bit 0 droite ; 1 sur du noir',
            it: 'V5: sensori di linea: bit 2 sinistra, bit 1 centro, bit 0 destra; 1 sul nero',
            en: 'V5: line sensors: bit 2 left, bit 1 middle, bit 0 right; 1 on black',
          },
        },
        {
          register: '0x20 … 0x25',
          access: 'R',
          meaning: {
            de: 'V5: Helligkeit am Boden links, Mitte, rechts, je zwei Bytes, das hohe zuerst',
            fr: 'V5 : luminosité du sol à gauche, au milieu, à droite, deux octets chacune, le fort en premier',
            it: 'V5: luminosità del pavimento a sinistra, al centro, a destra, due byte ciascuna, prima quello alto',
            en: 'V5: brightness of the ground left, middle, right, two bytes each, high byte first',
          },
        },
        {
          register: '0x29 … 0x2C',
          access: 'R',
          meaning: {
            de: 'V5: Licht von links, von rechts, je zwei Bytes, das hohe zuerst',
            fr: 'V5 : lumière venant de gauche, de droite, deux octets chacune, le fort en premier',
            it: 'V5: luce da sinistra, da destra, due byte ciascuna, prima quello alto',
            en: 'V5: light from the left, from the right, two bytes each, high byte first',
          },
        },
        {
          register: '0x2D, 0x2E',
          access: 'RW',
          meaning: {
            de: 'V5: Art der Batterie (0 Lithium, 1 Alkali) und wie voll sie ist, in %',
            fr: 'V5 : type de pile (0 lithium, 1 alcaline) et son niveau, en %',
            it: 'V5: tipo di batteria (0 litio, 1 alcalina) e quanto è carica, in %',
            en: 'V5: kind of battery (0 lithium, 1 alkaline) and how full it is, in %',
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
          meaning: { de: 'Versionstext', fr: 'texte de version', it: 'testo di versione', en: 'version text' },
        },
        {
          register: '0x46',
          access: 'W',
          meaning: {
            de: 'V5: Neustart: Lichter und Linienfolgen aus',
            fr: 'V5 : redémarrage : lumières et suivi de ligne éteints',
            it: 'V5: riavvio: luci e inseguimento della linea spenti',
            en: 'V5: start anew: lights and line following off',
          },
        },
        {
          register: '0x47, 0x48',
          access: 'RW',
          meaning: {
            de: 'V5: folgt von selbst einer Linie (1 ein, 0 aus) und wie schnell (1–3)',
            fr: 'V5 : suit tout seul une ligne (1 oui, 0 non), et sa vitesse (1–3)',
            it: 'V5: segue da solo una linea (1 sì, 0 no) e a che velocità (1–3)',
            en: 'V5: follows a line by itself (1 on, 0 off) and how fast (1–3)',
          },
        },
      ],
    },
  ],
};
