/** What a file is by its first bytes, where it is no text of rows. */
export type Container = { kind: 'text' } | { kind: 'gzip' } | { kind: 'refused'; message: string };

const decoder = new TextDecoder('latin1');

const ascii = (text: string): number[] => [...text].map((c) => c.charCodeAt(0));
const R_DATA =
  'this is R data (.rds, .RData); write the table as CSV in R: write.csv(run, "run.csv", row.names = FALSE)';

/** First bytes, and what to do in the tool that wrote such a file. */
const KNOWN: readonly { begins: readonly number[]; message: string }[] = [
  {
    begins: [0x89, 0x48, 0x44, 0x46],
    message:
      'this is an HDF5 file (or a MATLAB file of version 7.3); write the table as CSV: in Python pandas.read_hdf("file").to_csv("file.csv"), in MATLAB writetable(T, "file.csv")',
  },
  {
    begins: [0x50, 0x41, 0x52, 0x31],
    message:
      'this is a Parquet file; write it as CSV: in Python pandas.read_parquet("file").to_csv("file.csv", index=False)',
  },
  {
    begins: [0xd0, 0xcf, 0x11, 0xe0],
    message: 'this is an old Excel workbook (.xls); in Excel or LibreOffice choose File, Save as, CSV (UTF-8)',
  },
  {
    begins: [0x41, 0x52, 0x52, 0x4f, 0x57, 0x31],
    message:
      'this is an Arrow (Feather) file; write it as CSV: in Python pandas.read_feather("file").to_csv("file.csv", index=False)',
  },
  {
    begins: [0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59],
    message:
      'this is a NumPy array (.npy); write it as text: numpy.savetxt("file.csv", numpy.load("file.npy"), delimiter=",", header="t,…")',
  },
  {
    begins: [0x25, 0x50, 0x44, 0x46],
    message: 'this is a PDF; export the numbers behind it as CSV from the tool that made it',
  },
  {
    begins: [0x53, 0x51, 0x4c, 0x69, 0x74, 0x65],
    message:
      'this is an SQLite database; write the table as CSV: sqlite3 -header -csv file "select * from …" > file.csv',
  },
  { begins: [0x42, 0x5a, 0x68], message: 'this is a bzip2 archive; unpack it first (bunzip2 file)' },
  { begins: [0x28, 0xb5, 0x2f, 0xfd], message: 'this is a Zstandard archive; unpack it first (zstd -d file)' },
  { begins: [0xfd, 0x37, 0x7a, 0x58, 0x5a], message: 'this is an xz archive; unpack it first (unxz file)' },
  { begins: [0x37, 0x7a, 0xbc, 0xaf], message: 'this is a 7-Zip archive; unpack it first and open the CSV in it' },
  {
    begins: [0x23, 0x52, 0x4f, 0x53, 0x42, 0x41, 0x47],
    message: 'this is a ROS bag; write the topic as CSV: rostopic echo -b file.bag -p /topic > file.csv',
  },
  {
    begins: [0x89, 0x4d, 0x43, 0x41, 0x50],
    message: 'this is an MCAP recording; export the topic as CSV in the tool that shows it',
  },
  {
    begins: ascii('TDSm'),
    message:
      'this is a LabVIEW TDMS file; write it as text: in LabVIEW or DIAdem export as ASCII, in Python nptdms.TdmsFile.read("file").as_dataframe().to_csv("file.csv")',
  },
  {
    begins: ascii('MDF '),
    message:
      'this is an MDF measurement file; write it as CSV: in Python asammdf.MDF("file").export("csv", "file.csv")',
  },
  {
    begins: ascii('LOGG'),
    message: 'this is a CAN log (BLF); decode it with its database (DBC) and export the signals as CSV',
  },
  { begins: ascii('ULog'), message: 'this is a PX4 log (ULog); write it as CSV: ulog2csv file.ulg' },
  {
    begins: [0xa3, 0x95],
    message:
      'this is an ArduPilot log (.bin); write it as CSV: mavlogdump.py --format csv --types ATT file.bin > file.csv',
  },
  {
    begins: ascii('ORC'),
    message: 'this is an ORC file; write it as CSV: in Python pandas.read_orc("file").to_csv("file.csv", index=False)',
  },
  { begins: ascii('Obj\x01'), message: 'this is an Avro file; write it as CSV or as JSON lines' },
  { begins: ascii('Rar!'), message: 'this is a RAR archive; unpack it first and open the CSV in it' },
  { begins: ascii('{\\rtf'), message: 'this is a document in rich text (RTF); save the numbers as plain text or CSV' },
  { begins: ascii('RDX'), message: R_DATA },
  { begins: ascii('RDA'), message: R_DATA },
  { begins: [0x58, 0x0a, 0, 0, 0], message: R_DATA },
  { begins: [0x89, 0x50, 0x4e, 0x47], message: 'this is a picture (PNG), no table of numbers' },
  { begins: [0xff, 0xd8, 0xff], message: 'this is a picture (JPEG), no table of numbers' },
];

/** Tells by the first bytes (some hundred are enough). */
export function sniff(start: Uint8Array): Container {
  const begins = (bytes: readonly number[]): boolean => bytes.every((byte, i) => start[i] === byte);
  if (begins([0x1f, 0x8b])) return { kind: 'gzip' };
  const text = decoder.decode(start.subarray(0, 4096));
  if (text.startsWith('MATLAB 5.0 MAT-file') || text.startsWith('MATLAB 7.3 MAT-file'))
    return {
      kind: 'refused',
      message:
        'this is a MATLAB file (.mat) of variables; write the table as CSV in MATLAB: writetable(array2table([t x y], "VariableNames", {"t","x","y"}), "run.csv"), or writetimetable for a timetable',
    };
  if (begins([0x50, 0x4b, 0x03, 0x04])) return { kind: 'refused', message: zipped(text) };
  if (begins([0x50, 0x4b]) && (start[2] === 5 || start[2] === 7))
    return { kind: 'refused', message: 'this is an empty ZIP archive' };
  // A C3D file has 80 as its second byte and its parameters' block number first.
  if (start[1] === 0x50 && start[0]! >= 1 && start[0]! <= 8 && start.subarray(0, 64).includes(0))
    return {
      kind: 'refused',
      message: 'this is a C3D motion capture file; export the trajectories as CSV or TSV from the capture program',
    };
  const known = KNOWN.find(({ begins: bytes }) => begins(bytes));
  if (known) return { kind: 'refused', message: known.message };
  if (text.startsWith('ustar', 257))
    return { kind: 'refused', message: 'this is a tar archive; unpack it first (tar -xf file) and open the CSV in it' };
  if (start[0] === 0x80 && start[1]! >= 2 && start[1]! <= 5 && (start[2] === 0x95 || start.subarray(0, 64).includes(0)))
    return {
      kind: 'refused',
      message: 'this is a Python pickle; write it as CSV: pandas.read_pickle("file").to_csv("file.csv")',
    };
  const marked = markup(text.replace(/^(?:\ufeff|ï»¿)?\s*/, ''));
  return marked ? { kind: 'refused', message: marked } : { kind: 'text' };
}

/** Text that is no table of lines. */
function markup(text: string): string | null {
  if (/^<(?:!doctype html|html|head|body|table|meta|style)[\s>]/i.test(text))
    return 'this is an HTML page (some instruments call it .xls); open it in a spreadsheet and save it as CSV';
  if (/^<\?xml/i.test(text) || (/^<[a-z]/i.test(text) && /<\/[a-z][\w:.-]*>/i.test(text)))
    return 'this is XML; export the numbers as CSV from the tool that wrote it (a spreadsheet opens XML tables)';
  // `rostopic echo`: keys and indented values, one message after another.
  if (/^(?:---\r?\n)?[A-Za-z_]\w*:[ \t]*\r?\n(?:[ \t]+[A-Za-z_]\w*:|-[ \t])/.test(text) && /^---\s*$/m.test(text))
    return 'this is YAML, as ROS prints messages; write the topic as CSV: rostopic echo -p /topic > file.csv, or ros2 topic echo --csv /topic > file.csv';
  return null;
}

function zipped(text: string): string {
  if (/xl\/|\[Content_Types\]\.xml|docProps/.test(text))
    return 'this is an Excel workbook (.xlsx); in Excel or LibreOffice choose File, Save as, CSV (UTF-8)';
  if (text.includes('opendocument.spreadsheet'))
    return 'this is a LibreOffice spreadsheet (.ods); choose File, Save as, CSV';
  if (/\.npy/.test(text))
    return 'this is a NumPy archive (.npz); write its arrays as text with numpy.savetxt, delimiter=","';
  return 'this is a ZIP archive; unpack it and open the CSV in it';
}
