import type { Texts } from '#core/texts';

/** The words of the tour and of the greeting; they come with them. */
export const tourTexts = {
  tour: { de: 'Rundgang', fr: 'Visite guidée', it: 'Visita guidata', en: 'Tour' },
  place: { de: '{step} von {count}', fr: '{step} sur {count}', it: '{step} di {count}', en: '{step} of {count}' },
  next: { de: 'Weiter', fr: 'Suivant', it: 'Avanti', en: 'Next' },
  back: { de: 'Zurück', fr: 'Retour', it: 'Indietro', en: 'Back' },
  done: { de: 'Fertig', fr: 'Terminer', it: 'Fine', en: 'Done' },
  there: { de: 'Zeig mir, wo', fr: 'Montre-moi où', it: 'Mostrami dove', en: 'Show me where' },
  leave: {
    de: 'Rundgang verlassen',
    fr: 'Quitter la visite guidée',
    it: 'Lascia la visita guidata',
    en: 'Leave the tour',
  },
  left: {
    de: 'Der Rundgang wartet auf dich: im Menü unter «Rundgang fortsetzen».',
    fr: 'La visite guidée t’attend : dans le menu, sous « Continuer la visite guidée ».',
    it: 'La visita guidata ti aspetta: nel menu, sotto «Continua la visita guidata».',
    en: 'The tour waits for you: in the menu, under “Go on with the tour”.',
  },
  inMenu: {
    de: 'Das findest du hier im Menü.',
    fr: 'C’est ici, dans le menu.',
    it: 'Si trova qui, nel menu.',
    en: 'This is here, in the menu.',
  },
  welcome: {
    de: 'Willkommen! Womit möchtest du beginnen?',
    fr: 'Bienvenue ! Par quoi veux-tu commencer ?',
    it: 'Ciao! Con che cosa vuoi cominciare?',
    en: 'Welcome! What would you like to begin with?',
  },
  start: { de: 'Gleich loslegen', fr: 'Commencer tout de suite', it: 'Comincia subito', en: 'Start right away' },
  short: { de: 'Loslegen', fr: 'Commencer', it: 'Comincia', en: 'Start' },
} as const satisfies Readonly<Record<string, Texts>>;

interface StepTexts {
  readonly title: Texts;
  readonly text: Texts;
}

/** What the tour says at each step. */
export const stepTexts = {
  code: {
    title: { de: 'Dein Programm', fr: 'Ton programme', it: 'Il tuo programma', en: 'Your program' },
    text: {
      de: 'Hier schreibst du in Python. Es steht schon ein Programm da: Du kannst jede Zeile ändern.',
      fr: 'Ici tu écris en Python. Il y a déjà un programme : tu peux changer chaque ligne.',
      it: 'Qui scrivi in Python. C’è già un programma: puoi cambiare ogni riga.',
      en: 'Here you write in Python. There is a program already: you can change every line.',
    },
  },
  run: {
    title: { de: 'Lass es laufen', fr: 'Lance-le', it: 'Avvialo', en: 'Run it' },
    text: {
      de: 'Drücke jetzt auf «Simulieren».',
      fr: 'Appuie maintenant sur « Simuler ».',
      it: 'Premi ora «Simula».',
      en: 'Press “Simulate” now.',
    },
  },
  arena: {
    title: { de: 'Die Arena', fr: 'L’arène', it: 'L’arena', en: 'The arena' },
    text: {
      de: 'Hier fährt der Roboter. Du kannst ihn mit dem Finger oder der Maus an einen anderen Ort ziehen, auch während er fährt.',
      fr: 'Ici roule le robot. Tu peux le déplacer avec le doigt ou la souris, même pendant qu’il roule.',
      it: 'Qui si muove il robot. Puoi spostarlo con il dito o con il mouse, anche mentre si muove.',
      en: 'Here the robot drives. You can drag it to another place with your finger or the mouse, even while it drives.',
    },
  },
  board: {
    title: { de: 'Der Mikrocomputer', fr: 'La carte', it: 'La scheda', en: 'The microcomputer' },
    text: {
      de: 'Hier leuchtet die Anzeige. Drücke die Tasten A und B: Dein Programm kann darauf antworten. Darunter sind die Sensoren.',
      fr: 'Ici s’allume l’écran. Appuie sur les boutons A et B : ton programme peut y répondre. En dessous se trouvent les capteurs.',
      it: 'Qui si accende il display. Premi i pulsanti A e B: il tuo programma può rispondere. Sotto ci sono i sensori.',
      en: 'Here the display lights up. Press the buttons A and B: your program can answer. The sensors are below.',
    },
  },
  console: {
    title: { de: 'Die Konsole', fr: 'La console', it: 'La console', en: 'The console' },
    text: {
      de: 'Hier steht, was dein Programm mit print() schreibt. Geht etwas schief, erklärt sie dir den Fehler und zeigt die Zeile.',
      fr: 'Ici s’affiche ce que ton programme écrit avec print(). Si quelque chose ne va pas, elle t’explique l’erreur et montre la ligne.',
      it: 'Qui appare ciò che il tuo programma scrive con print(). Se qualcosa va storto, ti spiega l’errore e mostra la riga.',
      en: 'Here is what your program writes with print(). When something goes wrong, it explains the error and shows the line.',
    },
  },
  stop: {
    title: { de: 'Anhalten', fr: 'Arrêter', it: 'Fermare', en: 'Stop' },
    text: {
      de: '«Stopp» beendet das Programm. Danach änderst du etwas und versuchst es nochmals.',
      fr: '« Arrêter » met fin au programme. Ensuite tu changes quelque chose et tu essaies encore.',
      it: '«Ferma» termina il programma. Poi cambi qualcosa e provi di nuovo.',
      en: '“Stop” ends the program. Then you change something and try again.',
    },
  },
  tools: {
    title: { de: 'Selber bauen', fr: 'Construire toi-même', it: 'Costruisci tu', en: 'Build your own' },
    text: {
      de: 'Mit diesen Werkzeugen zeichnest du Linien, stellst Wände und Blöcke auf und setzt Start und Ziel. Alles lässt sich rückgängig machen.',
      fr: 'Avec ces outils, tu traces des lignes, tu poses des murs et des blocs, tu fixes le départ et l’arrivée. Tout peut s’annuler.',
      it: 'Con questi strumenti disegni linee, metti muri e blocchi e fissi partenza e arrivo. Tutto si può annullare.',
      en: 'With these tools you draw lines, put up walls and blocks, and set start and target. Everything can be undone.',
    },
  },
  course: {
    title: {
      de: 'Kurse und Beispiele',
      fr: 'Parcours et exemples',
      it: 'Percorsi ed esempi',
      en: 'Courses and examples',
    },
    text: {
      de: 'Hier warten viele fertige Kurse mit Aufgaben auf dich, dazu Beispiele. Deine Arbeit geht dabei nicht verloren.',
      fr: 'Ici t’attendent beaucoup de parcours prêts, avec des tâches et des exemples. Ton travail n’est pas perdu.',
      it: 'Qui ti aspettano molti percorsi pronti con compiti, ed esempi. Il tuo lavoro non va perso.',
      en: 'Many ready courses with tasks wait for you here, and examples too. Your work is not lost.',
    },
  },
  help: {
    title: { de: 'Hilfe', fr: 'Aide', it: 'Aiuto', en: 'Help' },
    text: {
      de: 'Die Hilfe erklärt jeden Knopf und jeden Befehl. Auf der Tastatur öffnest du sie mit F1. Viel Spass!',
      fr: 'L’aide explique chaque bouton et chaque commande. Au clavier, tu l’ouvres avec F1. Amuse-toi bien !',
      it: 'L’aiuto spiega ogni pulsante e ogni comando. Con la tastiera lo apri con F1. Buon divertimento!',
      en: 'The help explains every button and every command. On the keyboard it opens with F1. Have fun!',
    },
  },
} as const satisfies Readonly<Record<string, StepTexts>>;
