/** Calli:bot: its registers, for the gallery. */
import type { RegisterTable } from '../robot';

export const motorsTable: RegisterTable = {
  address: 0x20,
  title: { de: 'Motoren und Servos', fr: 'Moteurs et servos', it: 'Motori e servo', en: 'Motors and servos' },
  rows: [
    {
      register: '0x00',
      access: 'W',
      meaning: {
        de: 'links: Richtung, Kraft',
        fr: 'gauche : direction, puissance',
        it: 'sinistra: direzione, potenza',
        en: 'left: direction, power',
      },
    },
    {
      register: '0x02',
      access: 'W',
      meaning: {
        de: 'rechts: Richtung, Kraft',
        fr: 'droite : direction, puissance',
        it: 'destra: direzione, potenza',
        en: 'right: direction, power',
      },
    },
    {
      register: '0x14',
      access: 'W',
      meaning: { de: 'Servo S1: Winkel', fr: 'servo S1 : angle', it: 'servo S1: angolo', en: 'servo S1: angle' },
    },
    {
      register: '0x15',
      access: 'W',
      meaning: { de: 'Servo S2: Winkel', fr: 'servo S2 : angle', it: 'servo S2: angolo', en: 'servo S2: angle' },
    },
  ],
};

export const lightsTable: RegisterTable = {
  address: 0x21,
  title: { de: 'Lichter und Sensoren', fr: 'Lumières et capteurs', it: 'Luci e sensori', en: 'Lights and sensors' },
  rows: [
    {
      register: '0x00',
      access: 'W',
      meaning: {
        de: 'rote Lichter: Bit 0 links, Bit 1 rechts',
        fr: 'lumières rouges : bit 0 à gauche, bit 1 à droite',
        it: 'luci rosse: bit 0 a sinistra, bit 1 a destra',
        en: 'red lights: bit 0 left, bit 1 right',
      },
    },
    {
      register: '0x01 … 0x04',
      access: 'W',
      meaning: {
        de: 'Farblichter: Bit 0 grün, 1 rot, 2 blau, Bits 4 bis 7 Helligkeit',
        fr: 'LED de couleur : bit 0 vert, 1 rouge, 2 bleu, bits 4 à 7 luminosité',
        it: 'LED colorati: bit 0 verde, 1 rosso, 2 blu, bit da 4 a 7 luminosità',
        en: 'colour lights: bit 0 green, 1 red, 2 blue, bits 4 to 7 brightness',
      },
    },
    {
      register: 'Byte 0',
      access: 'R',
      meaning: {
        de: 'Bit 0 Linie rechts, 1 Linie links, 2 Stossfänger rechts, 3 Stossfänger links, 4 Taste ON, 5 Taste OFF; Bit 7 ist 1, beim Calli:bot 1 ist es 0',
        fr: 'bit 0 ligne à droite, 1 ligne à gauche, 2 pare-chocs à droite, 3 pare-chocs à gauche, 4 touche ON, 5 touche OFF ; le bit 7 vaut 1, sur le Calli:bot 1 il vaut 0',
        it: 'bit 0 linea a destra, 1 linea a sinistra, 2 paraurti a destra, 3 paraurti a sinistra, 4 tasto ON, 5 tasto OFF; il bit 7 è 1, sul Calli:bot 1 è 0',
        en: 'bit 0 line right, 1 line left, 2 bumper right, 3 bumper left, 4 key ON, 5 key OFF; bit 7 is 1, on the Calli:bot 1 it is 0',
      },
    },
    {
      register: 'Byte 1, 2',
      access: 'R',
      meaning: {
        de: 'Abstand in mm, hohes Byte zuerst',
        fr: 'distance en mm, octet de poids fort d’abord',
        it: 'distanza in mm, prima il byte alto',
        en: 'distance in mm, high byte first',
      },
    },
  ],
};

export const registersTable: RegisterTable = {
  address: 0x22,
  title: {
    de: 'Alle Teile ausser Servos (Calli:bot 2 und 2E)',
    fr: 'Tous les éléments sauf les servos (Calli:bot 2 et 2E)',
    it: 'Tutte le parti tranne i servo (Calli:bot 2 e 2E)',
    en: 'All parts but servos (Calli:bot 2 and 2E)',
  },
  rows: [
    {
      register: '0x01',
      access: 'W',
      meaning: {
        de: 'Motoren und Lichter aus',
        fr: 'éteint les moteurs et les lumières',
        it: 'spegne motori e luci',
        en: 'motors and lights off',
      },
    },
    {
      register: '0x02',
      access: 'W',
      meaning: {
        de: 'welcher Motor (1 links, 2 rechts, 3 beide), Richtung, Kraft; bei 3 folgen Richtung und Kraft für rechts',
        fr: 'quel moteur (1 gauche, 2 droite, 3 les deux), direction, puissance ; avec 3 suivent la direction et la puissance de droite',
        it: 'quale motore (1 sinistra, 2 destra, 3 entrambi), direzione, potenza; con 3 seguono direzione e potenza per la destra',
        en: 'which motor (1 left, 2 right, 3 both), direction, power; with 3, direction and power for the right one follow',
      },
    },
    {
      register: '0x03',
      access: 'W',
      meaning: {
        de: 'Farblicht 1 bis 4: Rot, Grün, Blau; rotes Licht 5 links, 6 rechts: Helligkeit; je 0 bis 16',
        fr: 'LED de couleur 1 à 4 : rouge, vert, bleu ; lumière rouge 5 à gauche, 6 à droite : luminosité ; chacun de 0 à 16',
        it: 'LED colorato da 1 a 4: rosso, verde, blu; luce rossa 5 a sinistra, 6 a destra: luminosità; ognuno da 0 a 16',
        en: 'colour light 1 to 4: red, green, blue; red light 5 left, 6 right: brightness; 0 to 16 each',
      },
    },
    {
      register: '0x05',
      access: 'W',
      meaning: {
        de: 'Radzähler auf 0: 1 links, 2 rechts, 3 beide (2E)',
        fr: 'compteurs de roue à 0 : 1 gauche, 2 droite, 3 les deux (2E)',
        it: 'contatori delle ruote a 0: 1 sinistra, 2 destra, 3 entrambi (2E)',
        en: 'encoders to 0: 1 left, 2 right, 3 both (2E)',
      },
    },
    {
      register: '0x80',
      access: 'R',
      meaning: {
        de: 'wie Byte 0 an 0x21, aber Bit 7 ist 0',
        fr: 'comme l’octet 0 à 0x21, mais le bit 7 vaut 0',
        it: 'come il byte 0 a 0x21, ma il bit 7 è 0',
        en: 'as byte 0 at 0x21, but bit 7 is 0',
      },
    },
    {
      register: '0x81 …',
      access: 'R',
      meaning: {
        de: 'Jede Antwort beginnt mit der Nummer des Registers, dann folgt der Wert, tiefes Byte zuerst.',
        fr: 'Chaque réponse commence par le numéro du registre, puis vient la valeur, octet de poids faible d’abord.',
        it: 'Ogni risposta comincia con il numero del registro, poi viene il valore, prima il byte basso.',
        en: 'Every answer begins with the number of the register; then comes the value, low byte first.',
      },
    },
    {
      register: '0x81',
      access: 'R',
      meaning: { de: 'Abstand in mm', fr: 'distance en mm', it: 'distanza in mm', en: 'distance in mm' },
    },
    {
      register: '0x82',
      access: 'R',
      meaning: {
        de: 'Typ (2 = Calli:bot 2, 3 = 2E), Firmware 4 Bytes, Seriennummer 4 Bytes',
        fr: 'type (2 = Calli:bot 2, 3 = 2E), firmware 4 octets, numéro de série 4 octets',
        it: 'tipo (2 = Calli:bot 2, 3 = 2E), firmware 4 byte, numero di serie 4 byte',
        en: 'type (2 = Calli:bot 2, 3 = 2E), firmware 4 bytes, serial number 4 bytes',
      },
    },
    {
      register: '0x83',
      access: 'R',
      meaning: {
        de: 'Spannung der Batterie in mV (2E)',
        fr: 'tension de la batterie en mV (2E)',
        it: 'tensione della batteria in mV (2E)',
        en: 'voltage of the battery in mV (2E)',
      },
    },
    {
      register: '0x84',
      access: 'R',
      meaning: {
        de: 'Spannung der Liniensensoren in mV, rechts, dann links',
        fr: 'tension des capteurs de ligne en mV, à droite, puis à gauche',
        it: 'tensione dei sensori di linea in mV, a destra, poi a sinistra',
        en: 'voltage of the line sensors in mV, right, then left',
      },
    },
    {
      register: '0x91',
      access: 'R',
      meaning: {
        de: 'Radzähler links, dann rechts, je 4 Bytes, rückwärts negativ (2E)',
        fr: 'compteurs de roue à gauche, puis à droite, 4 octets chacun, négatifs en arrière (2E)',
        it: 'contatori delle ruote a sinistra, poi a destra, 4 byte ognuno, negativi all’indietro (2E)',
        en: 'encoders left, then right, 4 bytes each, negative backward (2E)',
      },
    },
  ],
};

export const silentTable: RegisterTable = {
  address: 0x23,
  lastAddress: 0x27,
  title: {
    de: 'Ohne bekannte Aufgabe (Calli:bot 2 und 2E)',
    fr: 'Sans fonction connue (Calli:bot 2 et 2E)',
    it: 'Senza funzione conosciuta (Calli:bot 2 e 2E)',
    en: 'No known purpose (Calli:bot 2 and 2E)',
  },
  rows: [
    {
      register: '0x00 … 0xFF',
      access: 'RW',
      meaning: {
        de: 'antworten, wenn ein Programm den Bus absucht; Schreiben bewirkt nichts, Lesen gibt 0',
        fr: 'répondent quand un programme explore le bus ; écrire n’a aucun effet, lire donne 0',
        it: 'rispondono quando un programma esplora il bus; scrivere non ha effetto, leggere dà 0',
        en: 'answer when a program scans the bus; writing does nothing, reading gives 0',
      },
    },
  ],
};
