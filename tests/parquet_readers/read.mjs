// Prints Parquet files as JSON: {FILE: {hyparquet: table, duckdb: table, groups: rows per row group, metadata: {key: value}}},
// each table {columns: [name], rows: [[value]]}. 64-bit integers must fit a double.
import {DuckDBInstance} from '@duckdb/node-api';
import {asyncBufferFromFile, parquetMetadataAsync, parquetReadObjects, parquetSchema} from 'hyparquet';

function plain(value) {
  if (value === undefined || value === null) return null;
  if (typeof value === 'bigint') {
    if (!Number.isSafeInteger(Number(value))) throw new Error(`${value} does not fit a double`);
    return Number(value);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return Array.from(value, plain);
  if (value.items) return value.items.map(plain);
  return value;
}

async function withHyparquet(path) {
  const file = await asyncBufferFromFile(path);
  const metadata = await parquetMetadataAsync(file);
  const columns = parquetSchema(metadata).children.map(child => child.element.name);
  const rows = await parquetReadObjects({file, metadata});
  return {
    hyparquet: {columns, rows: rows.map(row => columns.map(name => plain(row[name])))},
    groups: metadata.row_groups.map(group => Number(group.num_rows)),
    metadata: Object.fromEntries((metadata.key_value_metadata ?? []).map(({key, value}) => [key, value])),
  };
}

async function withDuckdb(connection, path) {
  const reader = await connection.runAndReadAll(`SELECT * FROM read_parquet('${path.replaceAll("'", "''")}')`);
  return {duckdb: {columns: reader.columnNames(), rows: reader.getRows().map(row => row.map(plain)),
                   types: reader.columnTypes().map(String)}};
}

const connection = await (await DuckDBInstance.create(':memory:')).connect();
const files = {};
for (const path of process.argv.slice(2))
  files[path] = {...await withHyparquet(path), ...await withDuckdb(connection, path)};
console.log(JSON.stringify(files));
