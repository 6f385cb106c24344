// The words of check.html in four languages.

export const texts = {
  de: {
    title: 'Prüfung des Servers',
    asking: 'Dateien werden geholt …',
    noList: 'files.json fehlt oder ist beschädigt. Lade den ganzen Ordner noch einmal hoch.',
    toPage: 'Zu Parcours',
    sum: {
      ok: 'Alles in Ordnung. Die Klasse kann kommen.',
      warn: 'Parcours funktioniert. Etwas lässt sich noch verbessern.',
      bad: 'Etwas stimmt nicht. So geht es:',
    },
    findings: {
      https: {
        right: 'Die Verbindung ist sicher.',
        wrong: 'Die Adresse beginnt nicht mit https.',
        mend: 'Ohne https geht die Seite nicht ohne Netz, und kein Programm kommt per USB auf den Roboter. Richte ein Zertifikat ein, zum Beispiel von Let’s Encrypt.',
      },
      offline: {
        right: 'Die Seite geht auch ohne Netz.',
        wrong: 'Die Seite geht nicht ohne Netz.',
        mend: 'Dafür braucht es https, und sw.js muss als text/javascript kommen.',
      },
      missing: {
        right: 'Alle Dateien sind da.',
        wrong: 'Dateien fehlen.',
        mend: 'Lade den ganzen Ordner noch einmal hoch, auch den Ordner assets. Auf Gross und Klein in den Namen kommt es an.',
      },
      length: {
        right: 'Alle Dateien sind ganz.',
        wrong: 'Dateien haben eine falsche Länge.',
        mend: 'Lade sie noch einmal hoch, bei FTP binär. Oder sie sind von einer anderen Version: Lösche den alten Ordner assets zuerst.',
      },
      types: {
        right: 'Jede Datei kommt mit dem richtigen Typ.',
        wrong: 'Dateien kommen mit einem falschen Typ.',
        mend: '.js als text/javascript, .wasm als application/wasm, .webmanifest als application/manifest+json, .css als text/css. Bei Apache steht das in .htaccess, bei nginx in nginx.conf.',
      },
      compression: {
        right: 'Grosse Dateien kommen gepackt.',
        wrong: 'Grosse Dateien kommen ungepackt.',
        mend: 'Mit gzip lädt die Seite dreimal so schnell: bei Apache mod_deflate einschalten, bei nginx gzip on.',
      },
      stale: {
        right: 'Neue Versionen kommen sofort an.',
        wrong: 'Der Server sagt, dass Dateien nicht neu geholt werden sollen.',
        mend: 'Alles ausserhalb von assets mit Cache-Control: no-cache schicken. Sonst kommt eine neue Version nicht an.',
      },
      fresh: {
        right: 'Der Server sagt, was neu geholt wird.',
        wrong: 'Der Server sagt nicht, was neu geholt werden soll.',
        mend: 'Alles ausserhalb von assets mit Cache-Control: no-cache schicken.',
      },
      kept: {
        right: 'Was sich nie ändert, wird nur einmal geholt.',
        wrong: 'Was sich nie ändert, wird immer neu geholt.',
        mend: 'Den Ordner assets mit Cache-Control: public, max-age=31536000, immutable schicken.',
      },
      blocked: {
        right: 'Die Regeln des Servers lassen die Seite zu.',
        wrong: 'Die Regeln des Servers (Content-Security-Policy) sperren die Seite.',
        mend: 'Nimm die Regeln aus nginx.conf oder .htaccess. Die Dateien *.single.html bekommen keine.',
      },
      policy: {
        right: 'Der Server schickt die Sicherheitsregeln mit.',
        wrong: 'Der Server schickt keine Sicherheitsregeln (Content-Security-Policy) mit.',
        mend: 'Es geht auch ohne. Mit den Regeln aus nginx.conf oder .htaccess kommt kein Programm ins Netz, selbst bei einem Fehler nicht.',
      },
      boards: {
        right: 'Programme dürfen per USB auf den Roboter.',
        wrong: 'Der Server verbietet USB.',
        mend: 'Nimm usb=() und serial=() aus der Kopfzeile Permissions-Policy.',
      },
    },
  },
  fr: {
    title: 'Contrôle du serveur',
    asking: 'Les fichiers arrivent…',
    noList: 'files.json manque ou est abîmé. Téléverse encore une fois tout le dossier.',
    toPage: 'Vers Parcours',
    sum: {
      ok: 'Tout va bien. La classe peut venir.',
      warn: 'Parcours fonctionne. On peut encore améliorer quelque chose.',
      bad: 'Quelque chose ne va pas. Voici comment faire :',
    },
    findings: {
      https: {
        right: 'La connexion est sûre.',
        wrong: 'L’adresse ne commence pas par https.',
        mend: 'Sans https, la page ne marche pas sans réseau et aucun programme ne passe par USB vers le robot. Installe un certificat, par exemple de Let’s Encrypt.',
      },
      offline: {
        right: 'La page marche aussi sans réseau.',
        wrong: 'La page ne marche pas sans réseau.',
        mend: 'Il faut https, et sw.js doit arriver comme text/javascript.',
      },
      missing: {
        right: 'Tous les fichiers sont là.',
        wrong: 'Des fichiers manquent.',
        mend: 'Téléverse encore une fois tout le dossier, aussi le dossier assets. Les majuscules des noms comptent.',
      },
      length: {
        right: 'Tous les fichiers sont entiers.',
        wrong: 'Des fichiers n’ont pas la bonne longueur.',
        mend: 'Téléverse-les encore une fois, en FTP en mode binaire. Ou ils sont d’une autre version : efface d’abord l’ancien dossier assets.',
      },
      types: {
        right: 'Chaque fichier arrive avec le bon type.',
        wrong: 'Des fichiers arrivent avec un mauvais type.',
        mend: '.js comme text/javascript, .wasm comme application/wasm, .webmanifest comme application/manifest+json, .css comme text/css. Pour Apache, c’est dans .htaccess, pour nginx dans nginx.conf.',
      },
      compression: {
        right: 'Les grands fichiers arrivent compressés.',
        wrong: 'Les grands fichiers arrivent sans compression.',
        mend: 'Avec gzip la page charge trois fois plus vite : mod_deflate pour Apache, gzip on pour nginx.',
      },
      stale: {
        right: 'Une nouvelle version arrive aussitôt.',
        wrong: 'Le serveur dit de ne pas reprendre des fichiers.',
        mend: 'Tout ce qui est hors de assets doit partir avec Cache-Control: no-cache. Sinon une nouvelle version n’arrive pas.',
      },
      fresh: {
        right: 'Le serveur dit ce qu’il faut reprendre.',
        wrong: 'Le serveur ne dit pas ce qu’il faut reprendre.',
        mend: 'Tout ce qui est hors de assets doit partir avec Cache-Control: no-cache.',
      },
      kept: {
        right: 'Ce qui ne change jamais n’est pris qu’une fois.',
        wrong: 'Ce qui ne change jamais est repris à chaque fois.',
        mend: 'Le dossier assets doit partir avec Cache-Control: public, max-age=31536000, immutable.',
      },
      blocked: {
        right: 'Les règles du serveur laissent passer la page.',
        wrong: 'Les règles du serveur (Content-Security-Policy) bloquent la page.',
        mend: 'Prends les règles de nginx.conf ou de .htaccess. Les fichiers *.single.html n’en reçoivent pas.',
      },
      policy: {
        right: 'Le serveur envoie les règles de sécurité.',
        wrong: 'Le serveur n’envoie pas de règles de sécurité (Content-Security-Policy).',
        mend: 'Cela marche aussi sans. Avec les règles de nginx.conf ou de .htaccess, aucun programme n’atteint le réseau, même en cas d’erreur.',
      },
      boards: {
        right: 'Les programmes peuvent passer par USB vers le robot.',
        wrong: 'Le serveur interdit l’USB.',
        mend: 'Enlève usb=() et serial=() de l’en-tête Permissions-Policy.',
      },
    },
  },
  it: {
    title: 'Controllo del server',
    asking: 'I file arrivano…',
    noList: 'files.json manca o è danneggiato. Carica di nuovo tutta la cartella.',
    toPage: 'A Parcours',
    sum: {
      ok: 'Tutto a posto. La classe può venire.',
      warn: 'Parcours funziona. Qualcosa si può ancora migliorare.',
      bad: 'Qualcosa non va. Ecco come fare:',
    },
    findings: {
      https: {
        right: 'La connessione è sicura.',
        wrong: 'L’indirizzo non comincia con https.',
        mend: 'Senza https la pagina non va senza rete e nessun programma passa via USB sul robot. Installa un certificato, per esempio di Let’s Encrypt.',
      },
      offline: {
        right: 'La pagina va anche senza rete.',
        wrong: 'La pagina non va senza rete.',
        mend: 'Serve https, e sw.js deve arrivare come text/javascript.',
      },
      missing: {
        right: 'Tutti i file ci sono.',
        wrong: 'Mancano dei file.',
        mend: 'Carica di nuovo tutta la cartella, anche la cartella assets. Le maiuscole nei nomi contano.',
      },
      length: {
        right: 'Tutti i file sono interi.',
        wrong: 'Alcuni file hanno una lunghezza sbagliata.',
        mend: 'Caricali di nuovo, con FTP in modo binario. O sono di un’altra versione: cancella prima la vecchia cartella assets.',
      },
      types: {
        right: 'Ogni file arriva con il tipo giusto.',
        wrong: 'Alcuni file arrivano con un tipo sbagliato.',
        mend: '.js come text/javascript, .wasm come application/wasm, .webmanifest come application/manifest+json, .css come text/css. Per Apache sta in .htaccess, per nginx in nginx.conf.',
      },
      compression: {
        right: 'I file grandi arrivano compressi.',
        wrong: 'I file grandi arrivano senza compressione.',
        mend: 'Con gzip la pagina si carica tre volte più in fretta: mod_deflate per Apache, gzip on per nginx.',
      },
      stale: {
        right: 'Le versioni nuove arrivano subito.',
        wrong: 'Il server dice di non riprendere alcuni file.',
        mend: 'Tutto ciò che è fuori da assets va mandato con Cache-Control: no-cache. Altrimenti una versione nuova non arriva.',
      },
      fresh: {
        right: 'Il server dice che cosa va ripreso.',
        wrong: 'Il server non dice che cosa va ripreso.',
        mend: 'Tutto ciò che è fuori da assets va mandato con Cache-Control: no-cache.',
      },
      kept: {
        right: 'Ciò che non cambia mai si prende una volta sola.',
        wrong: 'Ciò che non cambia mai si riprende ogni volta.',
        mend: 'La cartella assets va mandata con Cache-Control: public, max-age=31536000, immutable.',
      },
      blocked: {
        right: 'Le regole del server lasciano passare la pagina.',
        wrong: 'Le regole del server (Content-Security-Policy) bloccano la pagina.',
        mend: 'Prendi le regole di nginx.conf o di .htaccess. I file *.single.html non ne ricevono.',
      },
      policy: {
        right: 'Il server manda le regole di sicurezza.',
        wrong: 'Il server non manda regole di sicurezza (Content-Security-Policy).',
        mend: 'Va anche senza. Con le regole di nginx.conf o di .htaccess nessun programma raggiunge la rete, nemmeno per un errore.',
      },
      boards: {
        right: 'I programmi possono passare via USB sul robot.',
        wrong: 'Il server vieta l’USB.',
        mend: 'Togli usb=() e serial=() dall’intestazione Permissions-Policy.',
      },
    },
  },
  en: {
    title: 'Check of the server',
    asking: 'Fetching files …',
    noList: 'files.json is missing or damaged. Upload the whole folder again.',
    toPage: 'To Parcours',
    sum: {
      ok: 'All is well. The class can come.',
      warn: 'Parcours works. Something can still be better.',
      bad: 'Something is wrong. This is how to mend it:',
    },
    findings: {
      https: {
        right: 'The connection is secure.',
        wrong: 'The address does not begin with https.',
        mend: 'Without https the page does not work without a network, and no program goes to the robot by USB. Set up a certificate, for example of Let’s Encrypt.',
      },
      offline: {
        right: 'The page works without a network, too.',
        wrong: 'The page does not work without a network.',
        mend: 'That needs https, and sw.js must come as text/javascript.',
      },
      missing: {
        right: 'All files are there.',
        wrong: 'Files are missing.',
        mend: 'Upload the whole folder again, the folder assets as well. Capital letters in names count.',
      },
      length: {
        right: 'All files are whole.',
        wrong: 'Files have a wrong length.',
        mend: 'Upload them again, by FTP in binary mode. Or they are of another version: delete the old folder assets first.',
      },
      types: {
        right: 'Each file comes with the right type.',
        wrong: 'Files come with a wrong type.',
        mend: '.js as text/javascript, .wasm as application/wasm, .webmanifest as application/manifest+json, .css as text/css. For Apache that is in .htaccess, for nginx in nginx.conf.',
      },
      compression: {
        right: 'Large files come compressed.',
        wrong: 'Large files come uncompressed.',
        mend: 'With gzip the page loads three times as fast: mod_deflate for Apache, gzip on for nginx.',
      },
      stale: {
        right: 'New versions arrive at once.',
        wrong: 'The server says that files need not be fetched again.',
        mend: 'Send all outside assets with Cache-Control: no-cache. Otherwise a new version does not arrive.',
      },
      fresh: {
        right: 'The server says what is fetched again.',
        wrong: 'The server does not say what is to be fetched again.',
        mend: 'Send all outside assets with Cache-Control: no-cache.',
      },
      kept: {
        right: 'What never changes is fetched only once.',
        wrong: 'What never changes is fetched again each time.',
        mend: 'Send the folder assets with Cache-Control: public, max-age=31536000, immutable.',
      },
      blocked: {
        right: 'The server’s rules let the page work.',
        wrong: 'The server’s rules (Content-Security-Policy) block the page.',
        mend: 'Take the rules of nginx.conf or .htaccess. The files *.single.html get none.',
      },
      policy: {
        right: 'The server sends the security rules.',
        wrong: 'The server sends no security rules (Content-Security-Policy).',
        mend: 'It works without them. With the rules of nginx.conf or .htaccess no program reaches the network, not even by a fault.',
      },
      boards: {
        right: 'Programs may go to the robot by USB.',
        wrong: 'The server forbids USB.',
        mend: 'Take usb=() and serial=() out of the header Permissions-Policy.',
      },
    },
  },
};
