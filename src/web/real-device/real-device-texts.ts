import type { Texts } from '#core/texts';

/** The words of the dialog for the real device; they come with it. */
export const realDeviceTexts = {
  title: {
    de: 'Aufs Gerät laden',
    fr: 'Charger sur l’appareil',
    it: 'Carica sul dispositivo',
    en: 'Put on the device',
  },
  close: { de: 'Schliessen', fr: 'Fermer', it: 'Chiudi', en: 'Close' },
  here: {
    de: 'läuft hier: in der Simulation.',
    fr: 's’exécute ici\u00a0: dans la simulation.',
    it: 'si esegue qui: nella simulazione.',
    en: 'runs here: in the simulation.',
  },
  there: {
    de: 'läuft draussen: auf deinem Mikrocomputer.',
    fr: 's’exécute en vrai\u00a0: sur ton micro-ordinateur.',
    it: 'si esegue fuori: sul tuo microcomputer.',
    en: 'runs out there: on your microcomputer.',
  },
  withCable: { de: 'Mit dem USB-Kabel', fr: 'Avec le câble USB', it: 'Con il cavo USB', en: 'With the USB cable' },
  stepPlug: {
    de: 'Schliess dein Gerät mit dem USB-Kabel an. MicroPython muss schon darauf sein.',
    fr: 'Branche ton appareil avec le câble USB. MicroPython doit déjà y être installé.',
    it: 'Collega il tuo dispositivo con il cavo USB. MicroPython deve già esserci.',
    en: 'Connect your device with the USB cable. MicroPython must be on it already.',
  },
  stepHold: {
    de: 'Heb den Roboter hoch: Das Programm startet sofort, wenn alles geladen ist.',
    fr: 'Soulève le robot\u00a0: le programme démarre dès que tout est chargé.',
    it: 'Solleva il robot: il programma parte appena tutto è caricato.',
    en: 'Lift the robot up: the program starts as soon as everything is loaded.',
  },
  stepChoose: {
    de: 'Drück «Aufs Gerät laden» und wähle dein Gerät in der Liste des Browsers.',
    fr: 'Clique sur «\u00a0Charger sur l’appareil\u00a0» et choisis ton appareil dans la liste du navigateur.',
    it: 'Premi «Carica sul dispositivo» e scegli il tuo dispositivo nella lista del browser.',
    en: 'Press “Put on the device” and choose your device in the browser’s list.',
  },
  other: {
    de: 'Mein Gerät fehlt in der Liste',
    fr: 'Mon appareil n’est pas dans la liste',
    it: 'Il mio dispositivo non è nella lista',
    en: 'My device is not in the list',
  },
  noBrowser: {
    de: 'Dieser Browser kommt nicht an den USB-Anschluss. Öffne Parcours auf einem Computer mit Chrome oder Edge, oder speichere unten die Dateien und lade sie mit WebTigerPython oder dem Python-Editor deines Geräts.',
    fr: 'Ce navigateur n’a pas accès au port USB. Ouvre Parcours sur un ordinateur avec Chrome ou Edge, ou enregistre les fichiers ci-dessous et charge-les avec WebTigerPython ou l’éditeur Python de ton appareil.',
    it: 'Questo browser non può usare la porta USB. Apri Parcours su un computer con Chrome o Edge, oppure salva i file qui sotto e caricali con WebTigerPython o con l’editor Python del tuo dispositivo.',
    en: 'This browser cannot reach the USB port. Open Parcours on a computer with Chrome or Edge, or save the files below and load them with WebTigerPython or your device’s Python editor.',
  },
  noFrame: {
    de: 'Parcours ist hier in eine andere Seite eingebaut, die den USB-Anschluss nicht freigibt. Öffne Parcours in einem eigenen Tab. (Wer die Seite betreut: Dem iframe fehlt allow="serial".)',
    fr: 'Parcours est intégré ici dans une autre page qui ne donne pas accès au port USB. Ouvre Parcours dans son propre onglet. (Pour qui gère la page\u00a0: il manque allow="serial" à l’iframe.)',
    it: 'Qui Parcours è inserito in un’altra pagina che non dà accesso alla porta USB. Apri Parcours in una scheda propria. (Per chi gestisce la pagina: all’iframe manca allow="serial".)',
    en: 'Here Parcours is part of another page, which does not let it use the USB port. Open Parcours in a tab of its own. (For whoever looks after the page: the iframe lacks allow="serial".)',
  },
  files: { de: 'Diese Dateien gehören dazu', fr: 'Les fichiers du projet', it: 'I file del progetto', en: 'The files' },
  library: { de: 'Bibliothek', fr: 'Bibliothèque', it: 'Libreria', en: 'Library' },
  size: { de: '{size} kB', fr: '{size} ko', it: '{size} kB', en: '{size} kB' },
  saveOne: { de: '{file} speichern', fr: 'Enregistrer {file}', it: 'Salva {file}', en: 'Save {file}' },
  saveZip: {
    de: 'Alle speichern (ZIP)',
    fr: 'Tout enregistrer (ZIP)',
    it: 'Salva tutto (ZIP)',
    en: 'Save all (ZIP)',
  },
  stop: { de: 'Abbrechen', fr: 'Annuler', it: 'Annulla', en: 'Cancel' },
  again: { de: 'Nochmals laden', fr: 'Charger à nouveau', it: 'Carica di nuovo', en: 'Put it on again' },
  replace: { de: 'Ersetzen', fr: 'Remplacer', it: 'Sostituisci', en: 'Replace' },
  saveFirst: {
    de: 'Zuerst sichern',
    fr: 'Sauvegarder d’abord',
    it: 'Prima salva',
    en: 'Save it first',
  },
  keep: { de: 'Behalten', fr: 'Garder', it: 'Mantieni', en: 'Keep' },
  progress: { de: 'Fortschritt', fr: 'Progression', it: 'Avanzamento', en: 'Progress' },
  firstWords: {
    de: 'Das Gerät meldet:',
    fr: 'L’appareil affiche\u00a0:',
    it: 'Il dispositivo segnala:',
    en: 'The device says:',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** What is said while it goes on, and how it ended. */
export const deviceStateTexts = {
  choosing: {
    de: 'Wähle dein Gerät in der Liste des Browsers.',
    fr: 'Choisis ton appareil dans la liste du navigateur.',
    it: 'Scegli il tuo dispositivo nella lista del browser.',
    en: 'Choose your device in the browser’s list.',
  },
  greeting: {
    de: 'Das laufende Programm wird angehalten …',
    fr: 'Le programme en cours est arrêté…',
    it: 'Il programma in corso viene fermato…',
    en: 'Stopping the program that runs …',
  },
  looking: {
    de: 'Was ist schon auf dem Gerät? {file}',
    fr: 'Qu’y a-t-il déjà sur l’appareil\u00a0? {file}',
    it: 'Che cosa c’è già sul dispositivo? {file}',
    en: 'What is on the device already? {file}',
  },
  writing: {
    de: '{file} wird geladen …',
    fr: 'Chargement de {file}…',
    it: 'Caricamento di {file}…',
    en: 'Loading {file} …',
  },
  checking: {
    de: '{file} wird geprüft …',
    fr: 'Vérification de {file}…',
    it: 'Controllo di {file}…',
    en: 'Checking {file} …',
  },
  starting: {
    de: 'Das Programm startet …',
    fr: 'Le programme démarre…',
    it: 'Il programma parte…',
    en: 'The program starts …',
  },
  asking: {
    de: 'Auf dem Gerät liegt schon etwas anderes, das nicht von hier stammt: {files}. Es ginge verloren. Ersetzen?',
    fr: 'Il y a déjà autre chose sur l’appareil, qui ne vient pas d’ici\u00a0: {files}. Ce serait perdu. Remplacer\u00a0?',
    it: 'Sul dispositivo c’è già qualcos’altro che non viene da qui: {files}. Andrebbe perso. Sostituire?',
    en: 'Something else is on the device already that does not come from here: {files}. It would be lost. Replace it?',
  },
  saved: {
    de: 'Auf diesem Computer gesichert: {files}. Jetzt ersetzen?',
    fr: 'Sauvegardé sur cet ordinateur\u00a0: {files}. Remplacer maintenant\u00a0?',
    it: 'Salvato su questo computer: {files}. Sostituire ora?',
    en: 'Saved on this computer: {files}. Replace it now?',
  },
  done: {
    de: 'Geladen und geprüft. Das Programm läuft jetzt auf dem Gerät ({machine}).',
    fr: 'Chargé et vérifié. Le programme s’exécute maintenant sur l’appareil ({machine}).',
    it: 'Caricato e controllato. Ora il programma è in esecuzione sul dispositivo ({machine}).',
    en: 'Loaded and checked. The program now runs on the device ({machine}).',
  },
  failedAtOnce: {
    de: 'Geladen und geprüft. Das Programm ist auf dem Gerät ({machine}) aber gleich mit einem Fehler stehen geblieben.',
    fr: 'Chargé et vérifié. Mais sur l’appareil ({machine}), le programme s’est tout de suite arrêté avec une erreur.',
    it: 'Caricato e controllato. Ma sul dispositivo ({machine}) il programma si è fermato subito con un errore.',
    en: 'Loaded and checked. But on the device ({machine}) the program stopped with an error at once.',
  },
  notStarted: {
    de: 'Geladen und geprüft. Drück jetzt den Reset-Knopf auf dem Gerät: Dann startet das Programm.',
    fr: 'Chargé et vérifié. Appuie maintenant sur le bouton reset de l’appareil\u00a0: le programme démarre.',
    it: 'Caricato e controllato. Ora premi il pulsante di reset del dispositivo: il programma parte.',
    en: 'Loaded and checked. Now press the reset button on the device: the program then starts.',
  },
  same: {
    de: 'Schon dort: {files}.',
    fr: 'Déjà sur l’appareil\u00a0: {files}.',
    it: 'Già sul dispositivo: {files}.',
    en: 'There already: {files}.',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** What went wrong, and what to do about it. */
export const deviceProblemTexts = {
  silent: {
    de: 'Das Gerät antwortet nicht. Prüfe das Kabel und drück den Reset-Knopf. Ist MicroPython darauf? Wenn nicht, lade einmal irgendein Programm aus dem Python-Editor deines Geräts darauf.',
    fr: 'L’appareil ne répond pas. Vérifie le câble et appuie sur le bouton reset. MicroPython y est-il installé\u00a0? Sinon, charge une fois un programme quelconque depuis l’éditeur Python de ton appareil.',
    it: 'Il dispositivo non risponde. Controlla il cavo e premi il pulsante di reset. C’è MicroPython? Se no, carica una volta un programma qualsiasi dall’editor Python del tuo dispositivo.',
    en: 'The device does not answer. Check the cable and press the reset button. Is MicroPython on it? If not, load any program onto it once from your device’s Python editor.',
  },
  'no-prompt': {
    de: 'Das Gerät sendet etwas, hört aber nicht zu. Vielleicht läuft ein Programm, das sich nicht anhalten lässt: Drück den Reset-Knopf und versuch es gleich nochmals. Oder es ist nicht MicroPython darauf.',
    fr: 'L’appareil envoie quelque chose mais n’écoute pas. Peut-être qu’un programme ne se laisse pas arrêter\u00a0: appuie sur le bouton reset et réessaie aussitôt. Ou ce n’est pas MicroPython.',
    it: 'Il dispositivo invia qualcosa, ma non ascolta. Forse c’è un programma che non si lascia fermare: premi il pulsante di reset e riprova subito. Oppure non c’è MicroPython.',
    en: 'The device sends something but does not listen. Perhaps a program runs that cannot be stopped: press the reset button and try again right away. Or what is on it is not MicroPython.',
  },
  'line-in-use': {
    de: 'Der Anschluss ist besetzt. Schliess andere Programme und Tabs, die mit dem Gerät verbunden sind, oder zieh das Kabel kurz aus und versuch es nochmals.',
    fr: 'Le port est occupé. Ferme les autres programmes et onglets connectés à l’appareil, ou débranche brièvement le câble, puis réessaie.',
    it: 'La porta è occupata. Chiudi gli altri programmi e le altre schede collegati al dispositivo, oppure stacca un attimo il cavo, e riprova.',
    en: 'The port is taken. Close other programs and tabs that are connected to the device, or pull out the cable for a moment, and try again.',
  },
  'wrong-board': {
    de: 'Dem Gerät ({machine}) fehlt das Modul {module}, das dein Programm importiert. Ist es das richtige Gerät? Es ist nichts verändert worden.',
    fr: 'Il manque à l’appareil ({machine}) le module {module} que ton programme importe. Est-ce le bon appareil\u00a0? Rien n’a été modifié.',
    it: 'Al dispositivo ({machine}) manca il modulo {module} che il tuo programma importa. È il dispositivo giusto? Non è stato cambiato nulla.',
    en: 'The device ({machine}) lacks the module {module}, which your program imports. Is it the right device? Nothing has been changed.',
  },
  full: {
    de: 'Auf dem Gerät ist zu wenig Platz: Bei {file} fehlen etwa {bytes} Bytes.',
    fr: 'Il n’y a pas assez de place sur l’appareil\u00a0: pour {file}, il manque environ {bytes} octets.',
    it: 'Sul dispositivo non c’è abbastanza spazio: per {file} mancano circa {bytes} byte.',
    en: 'There is not enough room on the device: at {file}, about {bytes} bytes are missing.',
  },
  fullOthers: {
    de: 'Dort liegen noch andere Dateien: {files}. Brauchst du sie nicht mehr, lösch sie mit dem Python-Editor deines Geräts.',
    fr: 'Il s’y trouve encore d’autres fichiers\u00a0: {files}. Si tu n’en as plus besoin, supprime-les avec l’éditeur Python de ton appareil.',
    it: 'Ci sono ancora altri file: {files}. Se non ti servono più, cancellali con l’editor Python del tuo dispositivo.',
    en: 'There are other files on it: {files}. If you no longer need them, delete them with your device’s Python editor.',
  },
  fullAlone: {
    de: 'Kürze dein Programm oder lass Bibliotheken weg, die du nicht brauchst.',
    fr: 'Raccourcis ton programme ou laisse de côté les bibliothèques inutiles.',
    it: 'Accorcia il tuo programma o togli le librerie che non ti servono.',
    en: 'Shorten your program, or leave out libraries that you do not need.',
  },
  interrupted: {
    de: 'Die Verbindung ist abgebrochen. Steck das Kabel wieder ein und lade nochmals: Vielleicht ist nicht alles auf dem Gerät.',
    fr: 'La connexion est coupée. Rebranche le câble et charge à nouveau\u00a0: il manque peut-être une partie sur l’appareil.',
    it: 'Il collegamento si è interrotto. Ricollega il cavo e carica di nuovo: forse sul dispositivo non c’è tutto.',
    en: 'The connection broke off. Plug the cable in again and put it on once more: perhaps not all of it is on the device.',
  },
  stuck: {
    de: 'Das Gerät antwortet mittendrin nicht mehr. Drück den Reset-Knopf und lade nochmals.',
    fr: 'L’appareil ne répond plus en cours de route. Appuie sur le bouton reset et charge à nouveau.',
    it: 'A metà strada il dispositivo non risponde più. Premi il pulsante di reset e carica di nuovo.',
    en: 'The device stopped answering midway. Press the reset button and put it on again.',
  },
  garbled: {
    de: 'Die Antworten des Geräts sind durcheinandergeraten. Drück den Reset-Knopf und lade nochmals. Hilft das nicht, nimm ein anderes Kabel.',
    fr: 'Les réponses de l’appareil sont embrouillées. Appuie sur le bouton reset et charge à nouveau. Si cela ne suffit pas, prends un autre câble.',
    it: 'Le risposte del dispositivo sono confuse. Premi il pulsante di reset e carica di nuovo. Se non basta, prova un altro cavo.',
    en: 'The device’s answers got mixed up. Press the reset button and put it on again. If that does not help, take another cable.',
  },
  different: {
    de: '{file} ist zweimal nicht richtig angekommen. Nimm ein anderes Kabel oder einen anderen USB-Anschluss.',
    fr: '{file} est mal arrivé deux fois. Prends un autre câble ou un autre port USB.',
    it: '{file} è arrivato due volte con errori. Prova un altro cavo o un’altra porta USB.',
    en: '{file} arrived wrong twice. Take another cable or another USB port.',
  },
  exception: {
    de: 'Python auf dem Gerät meldet einen Fehler. Drück den Reset-Knopf und lade nochmals.',
    fr: 'Python signale une erreur sur l’appareil. Appuie sur le bouton reset et charge à nouveau.',
    it: 'Python segnala un errore sul dispositivo. Premi il pulsante di reset e carica di nuovo.',
    en: 'Python on the device reports an error. Press the reset button and put it on again.',
  },
  stopped: {
    de: 'Abgebrochen. Auf dem Gerät ist kein ganzes Programm mehr: Lade nochmals.',
    fr: 'Annulé. Il n’y a plus de programme complet sur l’appareil\u00a0: charge à nouveau.',
    it: 'Annullato. Sul dispositivo non c’è più un programma completo: carica di nuovo.',
    en: 'Cancelled. There is no whole program on the device any more: put it on again.',
  },
} as const satisfies Readonly<Record<string, Texts>>;
