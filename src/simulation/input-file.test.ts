import { describe, expect, it } from 'vitest';
import { parseInputs } from './input-file';

describe('an input file', () => {
  it('gives every action its time in µs', () => {
    const text = `[
      {"at":"1s","button":"a","down":true},
      {"at":"2s","serial":"hi\\r\\n"},
      {"at":"3s","sensor":"lightLevel","value":10},
      {"at":"3500ms","sensor":"gesture","value":"shake"},
      {"at":"4s","place":{"xMm":0,"yMm":0,"headingDeg":90}},
      {"at":"5s","placeBlock":{"id":"b1","xMm":10,"yMm":20}},
      {"at":"6s","touch":"pinLogo","down":false},
      {"at":"7s","lamp":"l1","on":true},
      {"at":"7s","barrier":"g1","open":false},
      {"at":"7s","interrupt":true},
      {"at":"8s","radio":"go"},
      {"at":"9s","radio":[1,2,255]},
      {"at":"10s","arenaSenses":true},
      {"at":"10s","remote":"up","down":true},
      {"at":"10s","device":"pad","stick":{"x":0.5,"y":-1}},
      {"at":"10s","device":"pad","gamepad":"C","down":true},
      {"at":"11s","edit":{"type":"add","objects":[{"type":"block","id":"b2","at":[10,20],"size":[50,50]}]}}
    ]`;
    expect(parseInputs(text)).toEqual({
      inputs: [
        { timeUs: 1_000_000, action: { type: 'button', button: 'a', down: true } },
        { timeUs: 2_000_000, action: { type: 'serial', text: 'hi\r\n' } },
        { timeUs: 3_000_000, action: { type: 'sensor', id: 'lightLevel', value: 10 } },
        { timeUs: 3_500_000, action: { type: 'sensor', id: 'gesture', value: 'shake' } },
        { timeUs: 4_000_000, action: { type: 'place', pose: { xMm: 0, yMm: 0, headingDeg: 90 } } },
        { timeUs: 5_000_000, action: { type: 'place-block', id: 'b1', pose: { xMm: 10, yMm: 20, headingDeg: 0 } } },
        { timeUs: 6_000_000, action: { type: 'touch', pad: 'pinLogo', down: false } },
        { timeUs: 7_000_000, action: { type: 'switch', id: 'l1', on: true } },
        { timeUs: 7_000_000, action: { type: 'switch', id: 'g1', on: false } },
        { timeUs: 7_000_000, action: { type: 'interrupt' } },
        { timeUs: 8_000_000, action: { type: 'radio', text: 'go' } },
        { timeUs: 9_000_000, action: { type: 'radio', bytes: [1, 2, 255] } },
        { timeUs: 10_000_000, action: { type: 'arena-senses', on: true } },
        { timeUs: 10_000_000, action: { type: 'remote', key: 'up', down: true } },
        { timeUs: 10_000_000, device: 'pad', action: { type: 'stick', x: 0.5, y: -1 } },
        { timeUs: 10_000_000, device: 'pad', action: { type: 'gamepad', key: 'C', down: true } },
        {
          timeUs: 11_000_000,
          action: {
            type: 'edit',
            edit: { type: 'add', objects: [{ type: 'block', id: 'b2', at: [10, 20], size: [50, 50], angle: 0 }] },
          },
        },
      ],
    });
  });

  it('presses for a time: with "for", and a key of the remote control without anything for 0.2 s', () => {
    const text = `[{"at":"1s","remote":"up"},{"at":"2s","button":"a","for":"0.5s"}]`;
    expect(parseInputs(text)).toEqual({
      inputs: [
        { timeUs: 1_000_000, action: { type: 'remote', key: 'up', down: true } },
        { timeUs: 2_000_000, action: { type: 'button', button: 'a', down: true } },
        { timeUs: 1_199_999, action: { type: 'remote', key: 'up', down: false } },
        { timeUs: 2_499_999, action: { type: 'button', button: 'a', down: false } },
      ],
    });
  });

  it.each([
    ['{', /is not JSON/],
    ['{}', /must be a list/],
    ['[3]', /^\[0\]: must be an object/],
    ['[{"button":"a","down":true}]', /^\[0\]\.at: must be a time in quotes such as "1s"/],
    ['[{"at":1,"button":"a","down":true}]', /^\[0\]\.at: must be a time in quotes such as "1s", not 1/],
    ['[{"at":"1","button":"a","down":true}]', /^\[0\]\.at: "1" has no unit\. Did you mean 1s\?/],
    ['[{"at":"1s"}]', /^\[0\]: must have one of button, touch, remote, .*none of them/],
    ['[{"at":"1s","button":"a","serial":"x"}]', /^\[0\]: .*both button and serial/],
    ['[{"at":"1s","serial":"x"},{"at":"1s","button":"c","down":true}]', /^\[1\]\.button: must be "a" or "b", not "c"/],
    ['[{"at":"1s","button":"a"}]', /^\[0\]\.down: is missing; it must be true or false/],
    ['[{"at":"1s","button":"a","down":1}]', /^\[0\]\.down: must be true or false, not 1/],
    ['[{"at":"1s","button":"a","dwon":true}]', /^\[0\]\.dwon: is unknown here\. Known: at, device, button, down/],
    ['[{"at":"1s","touch":"pin9","down":true}]', /^\[0\]\.touch: must be one of pinLogo/],
    ['[{"at":"1s","sensor":"lightLevel","value":null}]', /^\[0\]\.value: must be a number or a text, not null/],
    ['[{"at":"1s","place":{"xMm":1}}]', /^\[0\]\.place\.yMm: is missing/],
    ['[{"at":"1s","place":{"x":1,"y":2}}]', /^\[0\]\.place\.x: is unknown here\. Known: xMm, yMm, headingDeg/],
    ['[{"at":"1s","placeBlock":{"xMm":1,"yMm":2}}]', /^\[0\]\.placeBlock\.id: is missing/],
    ['[{"at":"5s","radio":5}]', /^\[0\]\.radio: must be a text in quotes or a list of bytes, not 5/],
    ['[{"at":"5s","radio":[1,256]}]', /^\[0\]\.radio\[1\]: must be a whole number from 0 to 255, not 256/],
    ['[{"at":"5s","arenaSenses":1}]', /^\[0\]\.arenaSenses: must be true or false, not 1/],
    ['[{"at":"5s","remote":7}]', /^\[0\]\.remote: must be a key in quotes, one of power, .*up.*, 9, not 7/],
    ['[{"at":"5s","remote":"up","for":"0s"}]', /^\[0\]\.for: must be longer than nothing/],
    ['[{"at":"5s","remote":"up","for":"1s","down":true}]', /^\[0\]\.for: does not go with down/],
    ['[{"at":"5s","serial":"x","for":"1s"}]', /^\[0\]\.for: is unknown here/],
    [
      '[{"at":"5s","stick":{"x":2,"y":0}}]',
      /^\[0\]\.stick\.x: must be a number from -1 \(left\) to 1 \(right\), not 2/,
    ],
    ['[{"at":"5s","stick":{"x":0}}]', /^\[0\]\.stick\.y: is missing/],
    [
      '[{"at":"5s","gamepad":"A","down":true}]',
      /^\[0\]\.gamepad: must be a key in quotes, one of C, D, E, F, Z, not "A"/,
    ],
    ['[{"at":"5s","gamepad":"C"}]', /^\[0\]\.down: is missing/],
    ['[{"at":"5s","edit":5}]', /^\[0\]\.edit: must be an object/],
    ['[{"at":"5s","edit":{"type":"explode"}}]', /^\[0\]\.edit\.type: /],
    ['[{"at":"5s","edit":{"type":"remove","ids":[7]}}]', /^\[0\]\.edit\.ids\[0\]: must be a text in quotes, not 7/],
  ])('is refused when it is %s', (text, message) => {
    const parsed = parseInputs(text);
    expect('problem' in parsed ? parsed.problem : 'no problem').toMatch(message);
  });
});
