# The plugin for Jekyll: the tag `river_seed`. It draws each picture once, with the command `riverseed`, into Jekyll's cache.

require "cgi"
require "digest"
require "json"
require "open3"
require "uri"

module RiverSeed
  # An error that the site's author can mend; it says how.
  class Error < StandardError
    def initialize(message) = super("river-seed: #{message}")
  end

  LEAST = { "Jekyll" => "4.0", "riverseed" => "0.1.0" }.freeze
  # The longer side of the picture, a PNG of some 600 kB.
  SIZE = 960
  # Pixels of a screen to a CSS pixel, in a column of 640: letters are large enough to be read.
  RATIO = "1.5"

  def self.need(program, version)
    return if Gem::Version.new(version) >= Gem::Version.new(LEAST[program])
    raise Error, "#{program} #{LEAST[program]} or newer is needed; this is #{version}"
  end

  # Runs the command without a shell, so that no word is read as one.
  def self.riverseed(*words)
    said, status = Open3.capture2e("riverseed", *words)
    status.success? ? said : raise(Error, said.strip.delete_prefix("riverseed: "))
  rescue SystemCallError => error
    raise Error, "the command `riverseed` cannot be run: #{error.message}"
  rescue ArgumentError
    raise Error, "the text holds a character that cannot be shown"
  end

  # Names the edition of the algorithms in a link that names none, so that the element draws what the picture shows after an upgrade too.
  def self.pinned(link) = link.match?(/(\A\??|&)edition=/) ? link : "#{link}&edition=#{edition}"

  # Returns the edition that the command draws.
  def self.edition
    @edition ||= JSON.parse(riverseed("table", "--json"))["parameters"].find { |one| one["key"] == "edition" }["default"]
  end

  class Tag < Liquid::Tag
    def render(context)
      map, alt = @markup.scan(Liquid::QuotedFragment).map { |word| context.evaluate(Liquid::Expression.parse(word)) }
      raise Error, "a word or a link is wanted, as \"kauri\" or \"seed=kauri&land=valley\"" if map.to_s.strip.empty?
      map = map.to_s
      link = RiverSeed.pinned(map.match?(/\A\??[a-z][a-z-]*=/) ? map : "seed=#{URI.encode_www_form_component(map)}")
      site = context.registers[:site]
      name, width, height = picture(site, map, link)
      base = File.join("/", site.baseurl.to_s, "riverseed/")
      alt_or_own = alt || "Rivers grown from “#{URI.decode_www_form(link.delete_prefix("?")).assoc("seed")&.last || "kauri"}”"
      escape = ->(text) { CGI.escapeHTML(text.to_s) }
      %(<script type="module" src="#{base}river-seed.js"></script><river-seed recipe="#{escape[link]}"#{%( alt="#{escape[alt]}") if alt} style="display:block"><img src="#{base}#{name}" alt="#{escape[alt_or_own]}" width="#{width}" height="#{height}" style="display:block;width:100%;height:auto" /></river-seed>)
    end

    private

    # Returns the file name and the size of a map's picture, which Jekyll will write with the site's other files. The name is a hash of all
    # that decides the pixels.
    def picture(site, map, link)
      name = "river-seed-#{Digest::SHA256.hexdigest("#{map} edition #{RiverSeed.edition}, #{SIZE} at #{RATIO}")[0, 16]}.png"
      cache = File.join(site.cache_dir, "river-seed")
      path = File.join(cache, "riverseed", name)
      FileUtils.mkdir_p(File.dirname(path))
      RiverSeed.riverseed("render", link, "-o", path, "--size", SIZE.to_s, "--ratio", RATIO) unless File.exist?(path)
      file = Jekyll::StaticFile.new(site, cache, "riverseed", name)
      site.static_files << file unless site.static_files.any? { |other| other.path == file.path }
      [name, *File.binread(path, 8, 16).unpack("NN")]
    end
  end

  # Before anything is drawn: everything that has to be there is.
  Jekyll::Hooks.register :site, :after_init do |site|
    need("Jekyll", Jekyll::VERSION)
    need("riverseed", riverseed("--version")[/[\d.]+/])
    raise Error, "baseurl is a path such as \"/blog\", not \"#{site.baseurl}\"" unless site.baseurl.to_s.match?(%r{\A(/(?!/).*)?\z})
    raise Error, "the element's files are not in the folder riverseed of the site" unless File.exist?(site.in_source_dir("riverseed/river-seed.js"))
  end

  # Parts of a page in which a tag is only text: comments, scripts and styles.
  UNSEEN = %r{<!--.*?(?:-->|\z)|<(script|style)\b.*?</\1\s*>}mi

  Jekyll::Hooks.register %i[pages documents], :post_render do |page|
    raise Error, "a river-seed stands inside another: #{page.relative_path}" if page.output&.gsub(UNSEEN, "")&.match?(%r{<river-seed[\s>](?:(?!</river-seed>).)*<river-seed[\s>]}m)
  end
end

Liquid::Template.register_tag("river_seed", RiverSeed::Tag)
