// Reads NAME.ktx2 by a reader that is not ours. usage: node ktx_parse.mjs FILE
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

let read;
try {
  read = createRequire(import.meta.url)('ktx-parse').read;
} catch {
  console.log('SKIPPED: node has no package ktx-parse');
  process.exit(0);
}
const texture = read(new Uint8Array(readFileSync(process.argv[2])));
const expected = {vkFormat: 97, typeSize: 2, pixelWidth: 33, pixelHeight: 33, pixelDepth: 0, layerCount: 4,
                  faceCount: 1, supercompressionScheme: 0};
for (const [field, value] of Object.entries(expected)) {
  if (texture[field] !== value) throw new Error(`${field} is ${texture[field]}, expected ${value}`);
}
const level = texture.levels[0].levelData;
if (texture.levels.length !== 1 || level.byteLength !== 33 * 33 * 4 * 8) throw new Error('the level is not whole');
const format = texture.dataFormatDescriptor[0];
if (format.samples.length !== 4 || format.samples[3].channelType !== (15 | 0xC0)) throw new Error('the samples differ');
const keys = texture.keyValue;
if (!keys.warplutProvenance || !keys.warplutCertificate) throw new Error('a key is missing');
console.log('read', Object.keys(keys).join(' '));
