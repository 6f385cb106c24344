import { fn, module } from '#reference/table';
import type { RobotReference } from '#reference/types';

/** The names of this robot's library (library/new_robot.py) and short words on each. */
const library = module('new_robot', {
  motors: fn('(left: int, right: int) -> None'),
  forward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  stop: fn('() -> None'),
  setLED: fn('(on: int) -> None'),
  isLight: fn('() -> int'),
});

const de = {
  new_robot: 'Fährt den New Robot.',
  'new_robot.motors': 'Dreht das linke und das rechte Rad: -255 bis 255, negativ ist rückwärts.',
  'new_robot.forward': 'Fährt vorwärts, bis ein anderer Befehl kommt.',
  'new_robot.left': 'Dreht sich an Ort nach links, bis ein anderer Befehl kommt.',
  'new_robot.right': 'Dreht sich an Ort nach rechts, bis ein anderer Befehl kommt.',
  'new_robot.stop': 'Hält an.',
  'new_robot.setLED': 'Rotes Licht: 1 ein, 0 aus.',
  'new_robot.isLight': 'Der Boden unter dem Liniensensor: 1 hell, 0 dunkel.',
} as const;

const fr: Readonly<Record<keyof typeof de, string>> = {
  new_robot: 'Fait rouler le New Robot.',
  'new_robot.motors': 'Fait tourner la roue gauche et la roue droite : -255 à 255, négatif, c’est en arrière.',
  'new_robot.forward': 'Roule en avant jusqu’à la prochaine commande.',
  'new_robot.left': 'Tourne sur place vers la gauche jusqu’à la prochaine commande.',
  'new_robot.right': 'Tourne sur place vers la droite jusqu’à la prochaine commande.',
  'new_robot.stop': 'S’arrête.',
  'new_robot.setLED': 'Lumière rouge : 1 allumée, 0 éteinte.',
  'new_robot.isLight': 'Le sol sous le capteur de ligne : 1 clair, 0 sombre.',
};

const it: Readonly<Record<keyof typeof de, string>> = {
  new_robot: 'Guida il New Robot.',
  'new_robot.motors': 'Fa girare la ruota sinistra e la ruota destra: da -255 a 255, negativo è indietro.',
  'new_robot.forward': 'Va avanti finché arriva un altro comando.',
  'new_robot.left': 'Gira sul posto a sinistra finché arriva un altro comando.',
  'new_robot.right': 'Gira sul posto a destra finché arriva un altro comando.',
  'new_robot.stop': 'Si ferma.',
  'new_robot.setLED': 'Luce rossa: 1 accesa, 0 spenta.',
  'new_robot.isLight': 'Il pavimento sotto il sensore di linea: 1 chiaro, 0 scuro.',
};

const en: Readonly<Record<keyof typeof de, string>> = {
  new_robot: 'Drives the New Robot.',
  'new_robot.motors': 'Turns the left and the right wheel: -255 to 255, negative is backward.',
  'new_robot.forward': 'Drives forward until another command comes.',
  'new_robot.left': 'Turns left on the spot until another command comes.',
  'new_robot.right': 'Turns right on the spot until another command comes.',
  'new_robot.stop': 'Stops.',
  'new_robot.setLED': 'Red light: 1 on, 0 off.',
  'new_robot.isLight': 'The ground below the line sensor: 1 light, 0 dark.',
};

/** What the editor knows about the New Robot's library. */
export const newRobotReference: RobotReference = { robot: 'new-robot', modules: [library], texts: { de, fr, it, en } };
