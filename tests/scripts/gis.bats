# scripts/gis.sh: when the test with GDAL is left out.

load machine
setup() { new_machine; }

gis_sh() { run on_machine "$checkout/scripts/gis.sh" target/debug/riverseed; }

put_gdal() {
  local name
  for name in gdalinfo ogrinfo ogr2ogr gdal_translate; do program $name 3.6.2; done
}

@test "GDAL that can be had is installed" {
  offer gdal-bin 3.6.2
  gis_sh
  called 1 "apt-get install gdal-bin"
}

@test "where GDAL cannot be had it is left out, with a word" {
  gis_sh
  succeeded
  said "The test with a geographic information system is skipped: this machine has no GDAL."
}

@test "GDAL that is there is not asked for" {
  put_gdal
  gis_sh
  called 0 "apt-get install gdal-bin"
}
