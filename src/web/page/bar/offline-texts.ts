import type { Texts } from '#core/texts';

/** Words about new versions and about what a frame does not allow; they come late. */
export const offlineTexts = {
  update: {
    de: 'Eine neue Version von Parcours ist da. Deine Arbeit bleibt erhalten.',
    fr: 'Une nouvelle version de Parcours est prête. Ton travail reste en place.',
    it: 'È pronta una nuova versione di Parcours. Il tuo lavoro rimane.',
    en: 'A new version of Parcours is ready. Your work is kept.',
  },
  reload: { de: 'Jetzt neu laden', fr: 'Recharger maintenant', it: 'Ricarica ora', en: 'Reload now' },
  later: { de: 'Später', fr: 'Plus tard', it: 'Più tardi', en: 'Later' },
  close: { de: 'Schliessen', fr: 'Fermer', it: 'Chiudi', en: 'Close' },
  noStorage: {
    de: 'Hier lässt sich nichts speichern: Wenn die Seite zugeht, ist deine Arbeit weg.',
    fr: 'Ici, rien ne peut être enregistré : si la page se ferme, ton travail est perdu.',
    it: 'Qui non si può salvare nulla: se la pagina si chiude, il tuo lavoro va perso.',
    en: 'Nothing can be saved here: when the page closes, your work is gone.',
  },
  mayBeRefused: {
    de: 'Geschieht nichts? Dieser Rahmen erlaubt vielleicht weder Downloads noch Drucken: Kopiere dein Programm oder öffne Parcours in einem eigenen Fenster.',
    fr: 'Rien ne se passe ? Ce cadre interdit peut-être les téléchargements et l’impression : copie ton programme ou ouvre Parcours dans sa propre fenêtre.',
    it: 'Non succede nulla? Forse questo riquadro non permette né download né stampa: copia il tuo programma o apri Parcours in una finestra propria.',
    en: 'Nothing happens? This frame may allow neither downloads nor printing: copy your program, or open Parcours in a window of its own.',
  },
} as const satisfies Readonly<Record<string, Texts>>;
