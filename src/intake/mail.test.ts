import { describe, expect, it } from 'vitest';
import { linksInFile } from './links';
import { attachmentsIn } from './mail';

const LINK = 'https://parcours.example/app/#p=4.abcdef-_';
const found = (...lines: readonly string[]) =>
  linksInFile('mail.eml', lines.join('\r\n')).map(({ name, address }) => `${name}: ${address}`);
const base64 = (text: string): string =>
  (
    Buffer.from(text)
      .toString('base64')
      .match(/.{1,76}/g) ?? []
  ).join('\r\n');

describe('the links in a saved e-mail', () => {
  it('are found though its lines are broken and its signs are numbers: quoted-printable', () => {
    const mail = [
      'From: =?utf-8?Q?Zo=C3=AB_Weber?= <zoe@schule.example>',
      'Content-Type: text/plain; charset="UTF-8"',
      'Content-Transfer-Encoding: quoted-printable',
      '',
      'Gr=C3=BCezi,',
      'https://parcours.example/app/#p=3D4=',
      '.abcdef-_',
    ];
    expect(found(...mail)).toEqual([`Zoë Weber: ${LINK}`]);
  });

  it('are found in base64, named by the sender', () => {
    const mail = [
      'from: "Weber, Anna"',
      ' <anna@schule.example>',
      'content-transfer-encoding: BASE64',
      'content-type: text/plain; charset=iso-8859-1',
      '',
      Buffer.from(`Schöne Grüsse\n${LINK}\n`, 'latin1').toString('base64'),
    ];
    expect(found(...mail)).toEqual([`Weber, Anna: ${LINK}`]);
  });

  it('keep the names that stand beside them where one e-mail has several', () => {
    const body = `Anna: ${LINK}\nBen: ${LINK}0\n`;
    expect(found('From: Lehrerin <l@schule.example>', 'Content-Transfer-Encoding: base64', '', base64(body))).toEqual([
      `Anna: ${LINK}`,
      `Ben: ${LINK}0`,
    ]);
  });

  it('are there once where the e-mail has its text twice, as text and as page', () => {
    const mail = (text: string) => [
      'From: Ben <ben@schule.example>',
      'Content-Type: multipart/mixed; boundary="outer"',
      '',
      '--outer',
      'Content-Type: multipart/alternative;',
      '\tboundary=inner',
      '',
      '--inner',
      'Content-Type: text/plain',
      '',
      text,
      '--inner',
      'Content-Type: text/html; charset=utf-8',
      'Content-Transfer-Encoding: base64',
      '',
      base64(`<p>Hallo</p><p><a href="${LINK}">mein Link</a></p>`),
      '--inner--',
      '--outer',
      'Content-Type: image/png',
      'Content-Transfer-Encoding: base64',
      '',
      base64(`${LINK}9`),
      '--outer--',
    ];
    expect(found(...mail(LINK))).toEqual([`Ben: ${LINK}`]);
    // A link that only the page has is found there.
    expect(found(...mail('mein Link'))).toEqual([`Ben: ${LINK}`]);
  });

  it('are found in e-mails within an e-mail', () => {
    const mail = [
      'Content-Type: multipart/digest; boundary=b',
      '',
      '--b',
      'Content-Type: message/rfc822',
      '',
      'Content-Transfer-Encoding: base64',
      '',
      base64(`Anna: ${LINK}`),
      '--b--',
    ];
    expect(found(...mail)).toEqual([`Anna: ${LINK}`]);
  });

  it('are found in a text that is no e-mail, and in what is damaged no error comes', () => {
    expect(found('Hallo', '', `Anna: ${LINK}`)).toEqual([`Anna: ${LINK}`]);
    expect(found(`Anna: ${LINK}`)).toEqual([`Anna: ${LINK}`]);
    for (const text of ['Content-Transfer-Encoding: base64\n\n%%%', 'Content-Type: text/plain; charset=nothing\n\n=', 'Content-Type: multipart/mixed; boundary=\n\n--', 'From: =?x?Q?=ZZ?=\n\n'])
      expect(linksInFile('mail.eml', text)).toEqual([]); // prettier-ignore
  });

  it('do not keep anybody waiting who hands in e-mails within e-mails without end', () => {
    let mail = LINK;
    for (let level = 0; level < 2000; level += 1)
      mail = `Content-Type: multipart/mixed; boundary=b${String(level)}\n\n--b${String(level)}\n${mail}`;
    expect(linksInFile('mail.eml', mail)).toEqual([]);
  });

  it.each(['=', '= ', '=41', '=?', '=?a?Q?', '; ', ';boundary=', 'a:', '\n ', '\n--b', '--b\n\n'])(
    'are read in a megabyte of %j',
    (piece) => {
      const much = piece.repeat(Math.ceil(1_000_000 / piece.length));
      for (const head of ['From: ', 'Content-Transfer-Encoding: quoted-printable\n\n', 'Content-Type: ', 'Content-Type: multipart/mixed; boundary=b\n\n'])
        expect(linksInFile('mail.eml', `${head}${much}\n\n${LINK}`)).toBeInstanceOf(Array); // prettier-ignore
    },
  );
});

describe('the files in a saved e-mail', () => {
  const mail = (...head: readonly string[]) =>
    ['From: Zoë <z@x.example>', 'Content-Type: multipart/mixed; boundary=b', '', '--b', '', 'Hallo', '--b', ...head, '', base64('forward()'), '--b--'].join('\r\n'); // prettier-ignore
  const names = (text: string) => attachmentsIn(text).map(({ path, size }) => [path, size]);
  const coded = 'Content-Transfer-Encoding: base64';

  it('have their names, however they are written, and their bytes', () => {
    const named = (disposition: string) => names(mail(coded, `Content-Disposition: attachment; ${disposition}`));
    expect(named('filename="zoe.py"')).toEqual([['zoe.py', 9]]);
    expect(named("filename*=UTF-8''Zo%C3%AB.py")).toEqual([['Zoë.py', 9]]);
    expect(named('filename="=?utf-8?Q?Zo=C3=AB.py?="')).toEqual([['Zoë.py', 9]]);
    expect(named('filename="../a/zoe.py"')).toEqual([['zoe.py', 9]]);
    expect(names(mail(coded, 'Content-Type: text/x-python; name=zoe.py'))).toEqual([['zoe.py', 9]]);
    expect(names(mail(coded))).toEqual([]);
  });

  it('are never read beyond what is wanted', () => {
    const [file] = attachmentsIn(mail(coded, 'Content-Disposition: attachment; filename=zoe.py'));
    expect(file?.read(9)).toHaveProperty('bytes.length', 9);
    expect(file?.read(8)).toHaveProperty('problem.code', 'large');
  });
});
