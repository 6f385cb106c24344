import type { Texts } from '#core/texts';

/** Why a file cannot be the floor. */
export type BackgroundProblem = 'type' | 'file-too-large' | 'too-many-pixels' | 'unsafe' | 'damaged' | 'no-memory';

/** What is said then, with what to do about it. */
export const backgroundProblemTexts: Readonly<Record<BackgroundProblem, Texts>> = {
  type: {
    de: 'Das ist kein Bild, das Parcours lesen kann. Nimm ein Bild im Format PNG, JPEG oder SVG.',
    fr: 'Ce n’est pas une image que Parcours sait lire. Prends une image au format PNG, JPEG ou SVG.',
    it: 'Questa non è un’immagine che Parcours sa leggere. Usa un’immagine nel formato PNG, JPEG o SVG.',
    en: 'This is no picture that Parcours can read. Take a picture in the format PNG, JPEG or SVG.',
  },
  'file-too-large': {
    de: 'Die Datei ist grösser als 10 MB. Verkleinere das Bild und versuche es nochmals.',
    fr: 'Le fichier dépasse 10 MB. Réduis l’image et essaie encore une fois.',
    it: 'Il file supera 10 MB. Riduci l’immagine e riprova.',
    en: 'The file is larger than 10 MB. Make the picture smaller and try again.',
  },
  'too-many-pixels': {
    de: 'Das Bild hat mehr als 40 Millionen Bildpunkte. Verkleinere es und versuche es nochmals.',
    fr: 'L’image a plus de 40 millions de pixels. Réduis-la et essaie encore une fois.',
    it: 'L’immagine ha più di 40 milioni di pixel. Riducila e riprova.',
    en: 'The picture has more than 40 million pixels. Make it smaller and try again.',
  },
  unsafe: {
    de: 'Diese SVG-Datei enthält mehr als ein Bild: Programme, Bewegtes oder Teile aus dem Netz. Speichere sie als PNG und nimm diese.',
    fr: 'Ce fichier SVG contient plus qu’une image : des programmes, des animations ou des éléments du réseau. Enregistre-le en PNG et prends celui-ci.',
    it: 'Questo file SVG contiene più di un’immagine: programmi, animazioni o parti dalla rete. Salvalo come PNG e usa quello.',
    en: 'This SVG file contains more than a picture: programs, animations or parts from the net. Save it as PNG and take that.',
  },
  damaged: {
    de: 'Das Bild ist beschädigt: es lässt sich nicht öffnen.',
    fr: 'L’image est abîmée : impossible de l’ouvrir.',
    it: 'L’immagine è danneggiata: non si può aprire.',
    en: 'The picture is damaged: it cannot be opened.',
  },
  'no-memory': {
    de: 'Das Bild ist für dieses Gerät zu gross. Verkleinere es und versuche es nochmals.',
    fr: 'L’image est trop grande pour cet appareil. Réduis-la et essaie encore une fois.',
    it: 'L’immagine è troppo grande per questo dispositivo. Riducila e riprova.',
    en: 'The picture is too large for this device. Make it smaller and try again.',
  },
};
