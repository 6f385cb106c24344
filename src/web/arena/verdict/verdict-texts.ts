import type { Texts } from '#core/texts';
import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/verdict';

/** The words of the verdict bar; they come with it. */
export const verdictTexts = {
  title: { de: 'Aufgabe', fr: 'Tâche', it: 'Compito', en: 'Task' },
  notYet: { de: 'Noch nicht geschafft', fr: 'Pas encore réussi', it: 'Non ancora riuscito', en: 'Not done yet' },
  checkpoints: { de: 'Kontrollpunkte', fr: 'Points de contrôle', it: 'Punti di controllo', en: 'Checkpoints' },
  target: { de: 'Ziel', fr: 'Arrivée', it: 'Arrivo', en: 'Target' },
  targets: { de: 'Ziele', fr: 'Arrivées', it: 'Arrivi', en: 'Targets' },
  blocks: { de: 'Blöcke im Ziel', fr: 'Blocs à l’arrivée', it: 'Blocchi all’arrivo', en: 'Blocks delivered' },
  block: { de: 'Block im Ziel', fr: 'Bloc à l’arrivée', it: 'Blocco all’arrivo', en: 'Block delivered' },
  open: { de: 'offen', fr: 'à faire', it: 'da fare', en: 'open' },
  done: { de: 'erreicht', fr: 'atteint', it: 'raggiunto', en: 'reached' },
  ofMany: { de: '{done} von {of}', fr: '{done} sur {of}', it: '{done} di {of}', en: '{done} of {of}' },
  timeLeft: { de: 'noch {seconds} s', fr: 'encore {seconds} s', it: 'ancora {seconds} s', en: '{seconds} s left' },
  noTouch: { de: 'Nichts berühren', fr: 'Ne rien toucher', it: 'Non toccare niente', en: 'Touch nothing' },
  avoidZones: {
    de: 'Verbotene Felder meiden',
    fr: 'Éviter les zones interdites',
    it: 'Evita le zone vietate',
    en: 'Keep off the forbidden zones',
  },
  avoidSpikes: { de: 'Stacheln meiden', fr: 'Éviter les pics', it: 'Evita le punte', en: 'Keep off the spikes' },
  holdOut: {
    de: 'Durchhalten, bis die Zeit um ist',
    fr: 'Tenir jusqu’à la fin du temps',
    it: 'Resisti fino alla fine del tempo',
    en: 'Hold out until the time is over',
  },
  passed: { de: 'Geschafft!', fr: 'Réussi !', it: 'Ce l’hai fatta!', en: 'Well done!' },
  passedIn: {
    de: 'Aufgabe gelöst in {seconds} s.',
    fr: 'Tâche réussie en {seconds} s.',
    it: 'Compito riuscito in {seconds} s.',
    en: 'Task done in {seconds} s.',
  },
  failed: { de: 'Nicht geschafft', fr: 'Pas encore réussi', it: 'Non ancora', en: 'Not yet' },
  failedAfter: { de: 'nach {seconds} s', fr: 'après {seconds} s', it: 'dopo {seconds} s', en: 'after {seconds} s' },
  again: { de: 'Nochmals', fr: 'Encore une fois', it: 'Riprova', en: 'Try again' },
  againLong: {
    de: 'Nochmals: alles zurück an den Start',
    fr: 'Encore une fois : tout revient au départ',
    it: 'Riprova: tutto torna alla partenza',
    en: 'Try again: everything back to the start',
  },
  showPlace: { de: 'Zeigen', fr: 'Afficher', it: 'Mostra', en: 'Show' },
  showPlaceLong: {
    de: 'Zeigen, was im Weg war',
    fr: 'Afficher ce qui gênait',
    it: 'Mostra che cosa era in mezzo',
    en: 'Show what was in the way',
  },
  reached: {
    de: '{goal}: {done} von {of}.',
    fr: '{goal} : {done} sur {of}.',
    it: '{goal}: {done} di {of}.',
    en: '{goal}: {done} of {of}.',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** What happened, and what to do about it. */
export const reasonTexts: Readonly<Record<NonNullable<Verdict['reason']>, { what: Texts; todo: Texts }>> = {
  time: {
    what: { de: 'Die Zeit ist um.', fr: 'Le temps est écoulé.', it: 'Il tempo è scaduto.', en: 'The time is over.' },
    todo: {
      de: 'Fahr schneller oder kürze den Weg ab.',
      fr: 'Roule plus vite ou prends un chemin plus court.',
      it: 'Va’ più veloce o prendi una via più corta.',
      en: 'Drive faster or take a shorter way.',
    },
  },
  forbidden: {
    what: {
      de: 'Der Roboter ist auf ein verbotenes Feld gekommen.',
      fr: 'Le robot est arrivé sur une zone interdite.',
      it: 'Il robot è finito su una zona vietata.',
      en: 'The robot got onto a forbidden zone.',
    },
    todo: {
      de: 'Fahr in weiterem Bogen darum herum.',
      fr: 'Contourne-la plus largement.',
      it: 'Girale intorno più al largo.',
      en: 'Drive around it in a wider arc.',
    },
  },
  spikes: {
    what: {
      de: 'Der Roboter hat Stacheln berührt.',
      fr: 'Le robot a touché des pics.',
      it: 'Il robot ha toccato le punte.',
      en: 'The robot touched spikes.',
    },
    todo: {
      de: 'Bremse früher oder weiche aus.',
      fr: 'Freine plus tôt ou évite-les.',
      it: 'Frena prima o evitale.',
      en: 'Brake earlier or drive around them.',
    },
  },
  touched: {
    what: {
      de: 'Der Roboter hat {thing} berührt.',
      fr: 'Le robot a touché {thing}.',
      it: 'Il robot ha toccato {thing}.',
      en: 'The robot touched {thing}.',
    },
    todo: {
      de: 'Bremse früher oder lenke früher ein.',
      fr: 'Freine ou tourne plus tôt.',
      it: 'Frena o gira prima.',
      en: 'Brake or turn earlier.',
    },
  },
};

/** What may be touched, in the accusative; `edge` is that of the arena. */
export const thingTexts: Readonly<Record<'edge' | 'other' | SceneObject['type'], Texts>> = {
  edge: { de: 'den Rand der Arena', fr: 'le bord de l’arène', it: 'il bordo dell’arena', en: 'the edge of the arena' },
  other: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
  wall: { de: 'eine Wand', fr: 'un mur', it: 'un muro', en: 'a wall' },
  block: { de: 'einen Block', fr: 'un bloc', it: 'un blocco', en: 'a block' },
  'fixed-block': { de: 'einen festen Block', fr: 'un bloc fixe', it: 'un blocco fisso', en: 'a fixed block' },
  spikes: { de: 'Stacheln', fr: 'des pics', it: 'delle punte', en: 'spikes' },
  mover: { de: 'ein bewegtes Hindernis', fr: 'un obstacle mobile', it: 'un ostacolo mobile', en: 'a moving obstacle' },
  stroke: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
  target: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
  checkpoint: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
  forbidden: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
  label: { de: 'etwas', fr: 'quelque chose', it: 'qualcosa', en: 'something' },
};
