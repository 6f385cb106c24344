/** Commands that do the same on different robots, and the words by which pupils call them before they know the name. */
interface Meaning {
  readonly commands: readonly string[];
  readonly words: string;
}

/** Chosen: the words of the school's four languages, as imperative, infinitive and noun, and short forms. */
const MEANINGS: readonly Meaning[] = [
  {
    commands: ['forward', 'go_forward'],
    words: `vor vorne vorwärts geradeaus fahre fahren fahr los losfahren
      avant en_avant avancer avance avancez tout_droit
      avanti avanza avanzare diritto dritto
      ahead straight forwards fwd go drive move`,
  },
  {
    commands: ['backward', 'go_backward'],
    words: `zurück rückwärts hinten
      reculer recule reculez arrière en_arrière marche_arrière
      indietro all_indietro retromarcia arretra arretrare
      back backwards bwd reverse`,
  },
  {
    commands: ['turn_left', 'left'],
    words: `links nach_links linksherum
      gauche à_gauche
      sinistra a_sinistra
      left_turn`,
  },
  {
    commands: ['turn_right', 'right'],
    words: `rechts nach_rechts rechtsherum
      droite à_droite
      destra a_destra
      right_turn`,
  },
  {
    commands: ['leftArc'],
    words: `links_bogen bogen_links links_kurve kurve_links
      arc_gauche virage_gauche courbe_gauche arc_à_gauche virage_à_gauche
      arco_sinistra curva_sinistra arco_a_sinistra curva_a_sinistra
      arc_left left_curve curve_left left_circle`,
  },
  {
    commands: ['rightArc'],
    words: `rechts_bogen bogen_rechts rechts_kurve kurve_rechts
      arc_droite virage_droite courbe_droite arc_à_droite virage_à_droite
      arco_destra curva_destra arco_a_destra curva_a_destra
      arc_right right_curve curve_right right_circle`,
  },
  {
    commands: ['stop', 'pidControlStop'],
    words: `stopp stoppe stoppen halt halte anhalten bremse bremsen
      arrêt arrêter arrête arrêtez stopper freiner freine
      ferma fermati fermare frena frenare
      brake`,
  },
  {
    commands: ['delay', 'sleep'],
    words: `warte warten pausiere pausieren verzögerung
      attendre attends attendez attente délai
      aspetta aspettare attendi attendere attesa pausa
      wait pause sleep`,
  },
  {
    commands: ['setSpeed', 'set_motors_speed'],
    words: `geschwindigkeit tempo
      vitesse
      velocità
      speed velocity`,
  },
  {
    commands: ['getDistance', 'get_sonar_distance'],
    words: `abstand distanz entfernung ultraschall
      distance ultrason
      distanza ultrasuono
      sonar ultrasonic`,
  },
  {
    commands: ['setLED', 'rgbLED'],
    words: `licht lichter lampe lampen led leds
      lumière lampe phare phares
      luce luci faro fari
      light lights lamp lamps`,
  },
  {
    commands: ['setServo', 'set_servo_1_angle'],
    words: `servo servomotor servomoteur servomotore`,
  },
  { commands: ['setAlarm'], words: 'alarm alarme allarme' },
  {
    commands: ['beep'],
    words: `piep piepse piepsen hupe hupen
      bip biper klaxon klaxonner
      suona suonare clacson
      horn honk`,
  },
  {
    commands: ['fillRGB', 'rgbLED', 'fill'],
    words: `farbe farben
      couleur couleurs
      colore colori
      color colors colour colours`,
  },
  {
    commands: ['motL', 'motorL'],
    words: `motor_links linker_motor
      moteur_gauche
      motore_sinistro motore_sinistra
      left_motor motor_left mot_left`,
  },
  {
    commands: ['motR', 'motorR'],
    words: `motor_rechts rechter_motor
      moteur_droit moteur_droite
      motore_destro motore_destra
      right_motor motor_right mot_right`,
  },
  {
    commands: ['irLeft', 'irLeftValue', 'has_left_track'],
    words: `ir_links sensor_links linker_sensor
      ir_gauche capteur_gauche
      ir_sinistra sensore_sinistra sensore_sinistro
      left_sensor sensor_left left_ir`,
  },
  {
    commands: ['irRight', 'irRightValue', 'has_right_track'],
    words: `ir_rechts sensor_rechts rechter_sensor
      ir_droite ir_droit capteur_droit capteur_droite
      ir_destra sensore_destra sensore_destro
      right_sensor sensor_right right_ir`,
  },
  { commands: ['getLine'], words: 'linie ligne linea line' },
  {
    commands: ['read_digital', 'getValue'],
    words: `lies lesen wert
      lire lis valeur
      leggi leggere valore
      read value digital_read`,
  },
  {
    commands: ['rotate'],
    words: `drehe drehen dreh fahre
      tourner tourne
      gira girare ruota ruotare
      turn run spin`,
  },
];

/** Words around a command that add nothing to it, in the form of `folded`. */
const BEFORE = /^(?:fahren|fahre|fahr|gehe|geh|drehen|drehe|dreh|setze|lies|mesure[rz]?|mesurer|tourner|tourne|aller|gira|girare|vai|misura|set|get|measure|turn|drive|move|go)(?=.)/; // prettier-ignore
const AFTER = /^(.+)(?:fahren|gehen|drehen|messen|setzen)$/;

/** A word without capitals, accents and underscores; `ä` and `ae` are one, as pupils write both. */
const folded = (word: string): string =>
  word
    .normalize('NFD')
    .replace(/[\u0300-\u036f_]/g, '')
    .toLowerCase()
    .replace(/([aou])e/g, '$1');

/** The commands by the words that mean them, of every robot. */
const byWord: ReadonlyMap<string, readonly string[]> = (() => {
  const found = new Map<string, readonly string[]>();
  for (const { commands, words } of MEANINGS)
    for (const word of new Set([...commands, ...words.split(/\s+/)].map(folded)))
      found.set(word, [...(found.get(word) ?? []), ...commands]);
  return found;
})();

/**
 * The commands of robots that a word in German, French, Italian or English means, or a short form of their names, or
 * another robot's name for them: the likeliest first. Which of them a program has, depends on its robot.
 */
export function commandsMeantBy(word: string): readonly string[] {
  const whole = folded(word);
  const core = whole.replace(AFTER, '$1').replace(BEFORE, '');
  return [...new Set([...(byWord.get(whole) ?? []), ...(byWord.get(core) ?? [])])].filter((it) => it !== word);
}

/** All commands that words stand for, each with the words. */
export const otherNames: readonly { readonly commands: readonly string[]; readonly words: readonly string[] }[] =
  MEANINGS.map(({ commands, words }) => ({ commands, words: words.split(/\s+/) }));
