import { fn, module, type, value } from '#reference/table';
import type { RobotReference } from '#reference/types';

/** The names of this robot's libraries (library/*.py) and short words on each. */
const callibotModule = module('callibot', {
  forward: fn('() -> None'),
  backward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  leftArc: fn('(radius: float) -> None'),
  rightArc: fn('(radius: float) -> None'),
  stop: fn('() -> None'),
  exit: fn('() -> None'),
  setSpeed: fn('(speed: int) -> None'),
  delay: fn('(ms: float) -> None'),
  getDistance: fn('() -> float'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  tsValue: fn('() -> int'),
  tsLeftValue: fn('() -> int'),
  tsRightValue: fn('() -> int'),
  setLED: fn('(on: int) -> None'),
  setLEDLeft: fn('(on: int) -> None'),
  setLEDRight: fn('(on: int) -> None'),
  setAlarm: fn('(on: int) -> None'),
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('Sensor'),
  irRight: value('Sensor'),
  ts: value('Sensor'),
  tsLeft: value('Sensor'),
  tsRight: value('Sensor'),
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  Motor: type(['(register: int)'], { rotate: fn('(speed: int) -> None') }),
  Sensor: type(['(bits: int)'], { read_digital: fn('() -> int'), getValue: fn('() -> int') }),
});

const callibotmot = module('callibotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: fn('(on: int) -> None'),
  delay: fn('(ms: float) -> None'),
  Motor: type(['(number: int)'], { rotate: fn('(speed: int) -> None') }),
});

const cbalarm = module('cbalarm', { setAlarm: fn('(on: int) -> None'), beep: fn('() -> None') });

const de = {
  callibot: 'Fährt den Calli:bot: Motoren, Sensoren und rote Lichter.',
  'callibot.forward': 'Fährt vorwärts, bis ein anderer Befehl kommt.',
  'callibot.backward': 'Fährt rückwärts, bis ein anderer Befehl kommt.',
  'callibot.left': 'Dreht sich an Ort nach links, bis ein anderer Befehl kommt.',
  'callibot.right': 'Dreht sich an Ort nach rechts, bis ein anderer Befehl kommt.',
  'callibot.leftArc': 'Fährt einen Kreis nach links. radius in Metern: 0.2 sind 20 cm.',
  'callibot.rightArc': 'Fährt einen Kreis nach rechts. radius in Metern: 0.2 sind 20 cm.',
  'callibot.stop': 'Hält an.',
  'callibot.exit': 'Hält an, wie stop().',
  'callibot.setSpeed': 'Tempo der folgenden Fahrbefehle, etwa 10 bis 200; am Anfang 50.',
  'callibot.delay': 'Wartet so viele Millisekunden; der Roboter tut unterdessen weiter, was er tut.',
  'callibot.getDistance': 'Abstand zum nächsten Hindernis in cm, mit einer Stelle nach dem Punkt.',
  'callibot.irLeftValue':
    'Linker Liniensensor: 1 auf hellem Boden, 0 auf dunklem; 0 auch, solange der Stossfänger gedrückt ist.',
  'callibot.irRightValue':
    'Rechter Liniensensor: 1 auf hellem Boden, 0 auf dunklem; 0 auch, solange der Stossfänger gedrückt ist.',
  'callibot.tsValue':
    '1, solange der Stossfänger links und rechts gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.tsLeftValue':
    '1, solange der Stossfänger nur links gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.tsRightValue':
    '1, solange der Stossfänger nur rechts gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.setLED': 'Beide roten Lichter: 1 ein, 0 aus.',
  'callibot.setLEDLeft': 'Linkes rotes Licht: 1 ein, 0 aus. Das rechte geht dabei aus.',
  'callibot.setLEDRight': 'Rechtes rotes Licht: 1 ein, 0 aus. Das linke geht dabei aus.',
  'callibot.setAlarm': 'Zwei Töne immer wieder, im Hintergrund: 1 ein, 0 aus.',
  'callibot.motL': 'Der linke Motor: motL.rotate(50).',
  'callibot.motR': 'Der rechte Motor: motR.rotate(50).',
  'callibot.irLeft': 'Der linke Liniensensor: irLeft.read_digital() ist 1 auf hellem Boden, 0 auf dunklem.',
  'callibot.irRight': 'Der rechte Liniensensor: irRight.read_digital() ist 1 auf hellem Boden, 0 auf dunklem.',
  'callibot.ts': 'Der ganze Stossfänger: ts.getValue() ist 1, solange er links und rechts gedrückt ist.',
  'callibot.tsLeft': 'Der linke Teil des Stossfängers: tsLeft.getValue() ist 1, solange er gedrückt ist.',
  'callibot.tsRight': 'Der rechte Teil des Stossfängers: tsRight.getValue() ist 1, solange er gedrückt ist.',
  'callibot.w':
    'Stellt beide Motoren: Richtung links und rechts (0 vorwärts, 1 rückwärts), Kraft links und rechts (0 bis 255).',
  'callibot.Motor': 'Die Art von motL und motR.',
  'callibot.Motor.rotate': 'Dreht diesen Motor mit einem Tempo von -200 bis 200; negativ ist rückwärts, 0 hält an.',
  'callibot.Sensor': 'Die Art von irLeft, irRight, ts, tsLeft und tsRight.',
  'callibot.Sensor.read_digital': '1 auf hellem Boden oder gedrückt, sonst 0.',
  'callibot.Sensor.getValue': '1 auf hellem Boden oder gedrückt, sonst 0.',
  callibotmot: 'Die zwei Motoren des Calli:bot, jeder einzeln.',
  'callibotmot.motL': 'Der linke Motor: motL.rotate(50).',
  'callibotmot.motR': 'Der rechte Motor: motR.rotate(50).',
  'callibotmot.setLED': 'Beide roten Lichter: 1 ein, 0 aus.',
  'callibotmot.delay': 'Wartet so viele Millisekunden; der Roboter tut unterdessen weiter, was er tut.',
  'callibotmot.Motor': 'Ein Motor: 0 ist der linke, jede andere Zahl der rechte.',
  'callibotmot.Motor.rotate': 'Dreht diesen Motor mit einem Tempo von -200 bis 200; negativ ist rückwärts, 0 hält an.',
  cbalarm: 'Alarmtöne für den Calli:bot.',
  'cbalarm.setAlarm': 'Zwei Töne immer wieder, im Hintergrund: 1 ein, 0 aus.',
  'cbalarm.beep': 'Ein kurzer Ton von 2000 Hertz.',
} as const;

const fr: Readonly<Record<keyof typeof de, string>> = {
  callibot: 'Fait rouler le Calli:bot : moteurs, capteurs et lumières rouges.',
  'callibot.forward': 'Roule en avant jusqu’à la prochaine commande.',
  'callibot.backward': 'Roule en arrière jusqu’à la prochaine commande.',
  'callibot.left': 'Tourne sur place vers la gauche jusqu’à la prochaine commande.',
  'callibot.right': 'Tourne sur place vers la droite jusqu’à la prochaine commande.',
  'callibot.leftArc': 'Roule sur un cercle vers la gauche. radius en mètres : 0.2 fait 20 cm.',
  'callibot.rightArc': 'Roule sur un cercle vers la droite. radius en mètres : 0.2 fait 20 cm.',
  'callibot.stop': 'S’arrête.',
  'callibot.exit': 'S’arrête, comme stop().',
  'callibot.setSpeed': 'La vitesse des commandes suivantes, environ 10 à 200 ; 50 au départ.',
  'callibot.delay': 'Attend ce nombre de millisecondes ; pendant ce temps, le robot continue ce qu’il fait.',
  'callibot.getDistance': 'La distance jusqu’à l’obstacle le plus proche en cm, avec un chiffre après le point.',
  'callibot.irLeftValue':
    'Capteur de ligne gauche : 1 sur un sol clair, 0 sur un sol sombre ; 0 aussi tant que le pare-chocs est enfoncé.',
  'callibot.irRightValue':
    'Capteur de ligne droit : 1 sur un sol clair, 0 sur un sol sombre ; 0 aussi tant que le pare-chocs est enfoncé.',
  'callibot.tsValue':
    '1 tant que le pare-chocs est enfoncé à gauche et à droite. 0 aussi quand un seul des capteurs de ligne voit un sol clair.',
  'callibot.tsLeftValue':
    '1 tant que le pare-chocs est enfoncé à gauche seulement. 0 aussi quand un seul des capteurs de ligne voit un sol clair.',
  'callibot.tsRightValue':
    '1 tant que le pare-chocs est enfoncé à droite seulement. 0 aussi quand un seul des capteurs de ligne voit un sol clair.',
  'callibot.setLED': 'Les deux lumières rouges : 1 allumées, 0 éteintes.',
  'callibot.setLEDLeft': 'Lumière rouge gauche : 1 allumée, 0 éteinte. Celle de droite s’éteint alors.',
  'callibot.setLEDRight': 'Lumière rouge droite : 1 allumée, 0 éteinte. Celle de gauche s’éteint alors.',
  'callibot.setAlarm': 'Deux sons encore et encore, en arrière-plan : 1 en marche, 0 arrêt.',
  'callibot.motL': 'Le moteur gauche : motL.rotate(50).',
  'callibot.motR': 'Le moteur droit : motR.rotate(50).',
  'callibot.irLeft':
    'Le capteur de ligne gauche : irLeft.read_digital() donne 1 sur un sol clair, 0 sur un sol sombre.',
  'callibot.irRight':
    'Le capteur de ligne droit : irRight.read_digital() donne 1 sur un sol clair, 0 sur un sol sombre.',
  'callibot.ts': 'Tout le pare-chocs : ts.getValue() donne 1 tant qu’il est enfoncé à gauche et à droite.',
  'callibot.tsLeft': 'La partie gauche du pare-chocs : tsLeft.getValue() donne 1 tant qu’elle est enfoncée.',
  'callibot.tsRight': 'La partie droite du pare-chocs : tsRight.getValue() donne 1 tant qu’elle est enfoncée.',
  'callibot.w':
    'Règle les deux moteurs : sens à gauche et à droite (0 en avant, 1 en arrière), force à gauche et à droite (0 à 255).',
  'callibot.Motor': 'Le type de motL et motR.',
  'callibot.Motor.rotate':
    'Fait tourner ce moteur à une vitesse de -200 à 200 ; négatif, c’est en arrière, 0 l’arrête.',
  'callibot.Sensor': 'Le type de irLeft, irRight, ts, tsLeft et tsRight.',
  'callibot.Sensor.read_digital': '1 sur un sol clair ou enfoncé, sinon 0.',
  'callibot.Sensor.getValue': '1 sur un sol clair ou enfoncé, sinon 0.',
  callibotmot: 'Les deux moteurs du Calli:bot, chacun pour soi.',
  'callibotmot.motL': 'Le moteur gauche : motL.rotate(50).',
  'callibotmot.motR': 'Le moteur droit : motR.rotate(50).',
  'callibotmot.setLED': 'Les deux lumières rouges : 1 allumées, 0 éteintes.',
  'callibotmot.delay': 'Attend ce nombre de millisecondes ; pendant ce temps, le robot continue ce qu’il fait.',
  'callibotmot.Motor': 'Un moteur : 0 est celui de gauche, tout autre nombre celui de droite.',
  'callibotmot.Motor.rotate':
    'Fait tourner ce moteur à une vitesse de -200 à 200 ; négatif, c’est en arrière, 0 l’arrête.',
  cbalarm: 'Des sons d’alarme pour le Calli:bot.',
  'cbalarm.setAlarm': 'Deux sons encore et encore, en arrière-plan : 1 en marche, 0 arrêt.',
  'cbalarm.beep': 'Un son court de 2000 hertz.',
};

const it: Readonly<Record<keyof typeof de, string>> = {
  callibot: 'Guida il Calli:bot: motori, sensori e luci rosse.',
  'callibot.forward': 'Va avanti finché arriva un altro comando.',
  'callibot.backward': 'Va indietro finché arriva un altro comando.',
  'callibot.left': 'Gira sul posto a sinistra finché arriva un altro comando.',
  'callibot.right': 'Gira sul posto a destra finché arriva un altro comando.',
  'callibot.leftArc': 'Percorre un cerchio verso sinistra. radius in metri: 0.2 sono 20 cm.',
  'callibot.rightArc': 'Percorre un cerchio verso destra. radius in metri: 0.2 sono 20 cm.',
  'callibot.stop': 'Si ferma.',
  'callibot.exit': 'Si ferma, come stop().',
  'callibot.setSpeed': 'La velocità dei comandi seguenti, circa da 10 a 200; all’inizio 50.',
  'callibot.delay': 'Aspetta questo numero di millisecondi; intanto il robot continua quello che fa.',
  'callibot.getDistance': 'La distanza dall’ostacolo più vicino in cm, con una cifra dopo il punto.',
  'callibot.irLeftValue':
    'Sensore di linea sinistro: 1 su pavimento chiaro, 0 su pavimento scuro; 0 anche finché il paraurti è premuto.',
  'callibot.irRightValue':
    'Sensore di linea destro: 1 su pavimento chiaro, 0 su pavimento scuro; 0 anche finché il paraurti è premuto.',
  'callibot.tsValue':
    '1 finché il paraurti è premuto a sinistra e a destra. 0 anche quando solo uno dei sensori di linea vede chiaro.',
  'callibot.tsLeftValue':
    '1 finché il paraurti è premuto solo a sinistra. 0 anche quando solo uno dei sensori di linea vede chiaro.',
  'callibot.tsRightValue':
    '1 finché il paraurti è premuto solo a destra. 0 anche quando solo uno dei sensori di linea vede chiaro.',
  'callibot.setLED': 'Tutte e due le luci rosse: 1 accese, 0 spente.',
  'callibot.setLEDLeft': 'Luce rossa sinistra: 1 accesa, 0 spenta. Quella destra intanto si spegne.',
  'callibot.setLEDRight': 'Luce rossa destra: 1 accesa, 0 spenta. Quella sinistra intanto si spegne.',
  'callibot.setAlarm': 'Due suoni che si ripetono, sullo sfondo: 1 acceso, 0 spento.',
  'callibot.motL': 'Il motore sinistro: motL.rotate(50).',
  'callibot.motR': 'Il motore destro: motR.rotate(50).',
  'callibot.irLeft':
    'Il sensore di linea sinistro: irLeft.read_digital() dà 1 su pavimento chiaro, 0 su pavimento scuro.',
  'callibot.irRight':
    'Il sensore di linea destro: irRight.read_digital() dà 1 su pavimento chiaro, 0 su pavimento scuro.',
  'callibot.ts': 'Tutto il paraurti: ts.getValue() dà 1 finché è premuto a sinistra e a destra.',
  'callibot.tsLeft': 'La parte sinistra del paraurti: tsLeft.getValue() dà 1 finché è premuta.',
  'callibot.tsRight': 'La parte destra del paraurti: tsRight.getValue() dà 1 finché è premuta.',
  'callibot.w':
    'Regola i due motori: direzione a sinistra e a destra (0 avanti, 1 indietro), forza a sinistra e a destra (da 0 a 255).',
  'callibot.Motor': 'Il tipo di motL e motR.',
  'callibot.Motor.rotate': 'Fa girare questo motore a una velocità da -200 a 200; negativo è indietro, 0 lo ferma.',
  'callibot.Sensor': 'Il tipo di irLeft, irRight, ts, tsLeft e tsRight.',
  'callibot.Sensor.read_digital': '1 su pavimento chiaro o premuto, altrimenti 0.',
  'callibot.Sensor.getValue': '1 su pavimento chiaro o premuto, altrimenti 0.',
  callibotmot: 'I due motori del Calli:bot, uno per uno.',
  'callibotmot.motL': 'Il motore sinistro: motL.rotate(50).',
  'callibotmot.motR': 'Il motore destro: motR.rotate(50).',
  'callibotmot.setLED': 'Tutte e due le luci rosse: 1 accese, 0 spente.',
  'callibotmot.delay': 'Aspetta questo numero di millisecondi; intanto il robot continua quello che fa.',
  'callibotmot.Motor': 'Un motore: 0 è quello sinistro, ogni altro numero quello destro.',
  'callibotmot.Motor.rotate': 'Fa girare questo motore a una velocità da -200 a 200; negativo è indietro, 0 lo ferma.',
  cbalarm: 'Suoni d’allarme per il Calli:bot.',
  'cbalarm.setAlarm': 'Due suoni che si ripetono, sullo sfondo: 1 acceso, 0 spento.',
  'cbalarm.beep': 'Un suono breve di 2000 hertz.',
};

const en: Readonly<Record<keyof typeof de, string>> = {
  callibot: 'Drives the Calli:bot: motors, sensors and red lights.',
  'callibot.forward': 'Drives forward until another command comes.',
  'callibot.backward': 'Drives backward until another command comes.',
  'callibot.left': 'Turns left on the spot until another command comes.',
  'callibot.right': 'Turns right on the spot until another command comes.',
  'callibot.leftArc': 'Drives a circle to the left. radius in metres: 0.2 is 20 cm.',
  'callibot.rightArc': 'Drives a circle to the right. radius in metres: 0.2 is 20 cm.',
  'callibot.stop': 'Stops.',
  'callibot.exit': 'Stops, as stop().',
  'callibot.setSpeed': 'Speed of the following movements, about 10 to 200; 50 at the start.',
  'callibot.delay': 'Waits for this many milliseconds; meanwhile the robot goes on with what it does.',
  'callibot.getDistance': 'Distance to the nearest obstacle in cm, with one decimal.',
  'callibot.irLeftValue': 'Left line sensor: 1 on light ground, 0 on dark ground; 0 also while the bumper is pressed.',
  'callibot.irRightValue':
    'Right line sensor: 1 on light ground, 0 on dark ground; 0 also while the bumper is pressed.',
  'callibot.tsValue':
    '1 while the bumper is pressed left and right. 0 also while only one of the line sensors sees light ground.',
  'callibot.tsLeftValue':
    '1 while the bumper is pressed on the left only. 0 also while only one of the line sensors sees light ground.',
  'callibot.tsRightValue':
    '1 while the bumper is pressed on the right only. 0 also while only one of the line sensors sees light ground.',
  'callibot.setLED': 'Both red lights: 1 on, 0 off.',
  'callibot.setLEDLeft': 'Left red light: 1 on, 0 off. The right one goes off.',
  'callibot.setLEDRight': 'Right red light: 1 on, 0 off. The left one goes off.',
  'callibot.setAlarm': 'Two tones again and again in the background: 1 on, 0 off.',
  'callibot.motL': 'The left motor: motL.rotate(50).',
  'callibot.motR': 'The right motor: motR.rotate(50).',
  'callibot.irLeft': 'The left line sensor: irLeft.read_digital() is 1 on light ground, 0 on dark ground.',
  'callibot.irRight': 'The right line sensor: irRight.read_digital() is 1 on light ground, 0 on dark ground.',
  'callibot.ts': 'The whole bumper: ts.getValue() is 1 while it is pressed left and right.',
  'callibot.tsLeft': 'The left half of the bumper: tsLeft.getValue() is 1 while it is pressed.',
  'callibot.tsRight': 'The right half of the bumper: tsRight.getValue() is 1 while it is pressed.',
  'callibot.w': 'Sets both motors: direction left and right (0 forward, 1 backward), power left and right (0 to 255).',
  'callibot.Motor': 'The kind of motL and motR.',
  'callibot.Motor.rotate': 'Turns this motor with a speed of -200 to 200; negative is backward, 0 stops.',
  'callibot.Sensor': 'The kind of irLeft, irRight, ts, tsLeft and tsRight.',
  'callibot.Sensor.read_digital': '1 on light ground or pressed, else 0.',
  'callibot.Sensor.getValue': '1 on light ground or pressed, else 0.',
  callibotmot: 'The two motors of the Calli:bot, one by one.',
  'callibotmot.motL': 'The left motor: motL.rotate(50).',
  'callibotmot.motR': 'The right motor: motR.rotate(50).',
  'callibotmot.setLED': 'Both red lights: 1 on, 0 off.',
  'callibotmot.delay': 'Waits for this many milliseconds; meanwhile the robot goes on with what it does.',
  'callibotmot.Motor': 'A motor: 0 is the left one, any other number the right one.',
  'callibotmot.Motor.rotate': 'Turns this motor with a speed of -200 to 200; negative is backward, 0 stops.',
  cbalarm: 'Alarm sounds for the Calli:bot.',
  'cbalarm.setAlarm': 'Two tones again and again in the background: 1 on, 0 off.',
  'cbalarm.beep': 'A short tone of 2000 hertz.',
};

/** What the editor knows about the Calli:bot's libraries. */
export const callibotReference: RobotReference = {
  robot: 'callibot',
  modules: [callibotModule, callibotmot, cbalarm],
  texts: { de, fr, it, en },
};
